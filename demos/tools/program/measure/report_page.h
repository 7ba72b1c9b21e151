#pragma once

namespace demos {

/// @NAME@ is filled in: of the page by report.cpp, of a section by report_section.cpp.
constexpr const char* reportHead = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>@TITLE@</title>
<style>
:root { color-scheme: light dark; }
body { margin: 0 auto; padding: 1.5rem; max-width: max(60rem, @WIDTH@px); background: Canvas; color: CanvasText;
       font: 15px/1.5 system-ui, sans-serif; }
h1 { margin: 0 0 .5rem; font-size: 1.3rem; font-weight: 600; }
h2 { margin: 0 0 .25rem; font-size: 1.1rem; font-weight: 600; overflow-wrap: anywhere; }
section { margin: 2rem 0; padding-top: 1rem; border-top: 1px solid #8886; content-visibility: auto;
          contain-intrinsic-size: auto 60rem; }
p { margin: .25rem 0; overflow-wrap: anywhere; }
.verdict { display: inline-block; margin-right: .6rem; padding: .1rem .6rem; border-radius: .3rem; color: #fff; }
.same { background: #1f7a4d; }
.different { background: #b3392f; }
.bad, .advice { background: #8a5a00; }
fieldset { margin: .6rem 0; padding: 0; border: 0; }
label { margin-right: 1rem; }
.failures section.passed { display: none; }
.picture { display: block; width: 100%; }
.small .picture { image-rendering: pixelated; }
.stage { position: relative; --split: 50%; cursor: ew-resize; touch-action: pan-y; user-select: none; }
.stage:focus-visible { outline: 3px solid #2f7fd6; outline-offset: 3px; }
.before { position: absolute; inset: 0; clip-path: inset(0 calc(100% - var(--split)) 0 0); }
.line { position: absolute; top: 0; bottom: 0; left: var(--split); width: 2px; margin-left: -1px; background: #fff;
        box-shadow: 0 0 3px #000; pointer-events: none; }
.line::after { content: "\2194"; position: absolute; top: 50%; left: 50%; width: 2rem; height: 2rem;
               transform: translate(-50%, -50%); border-radius: 50%; background: #fff; color: #1b1d1f;
               line-height: 2rem; text-align: center; box-shadow: 0 0 3px #000; }
.box { position: absolute; border: 2px dashed #ff2fd0; pointer-events: none; }
.zooms { display: flex; flex-wrap: wrap; gap: .6rem; margin: .3rem 0 .9rem; }
.zooms div { image-rendering: pixelated; }
.flicker .line, .flicker .right { visibility: hidden; }
.flicker .before { clip-path: none; }
.flicker.blink .before, .flicker.blink .left { visibility: hidden; }
.flicker.blink .right { visibility: visible; }
.tag { position: absolute; bottom: .6rem; padding: 0 .5rem; border-radius: .2rem; background: #000a; color: #fff;
       font-size: .85rem; pointer-events: none; }
.left { left: .6rem; }
.right { right: .6rem; }
.scale { height: .8rem; margin-top: .6rem; background: linear-gradient(to right, @GRADIENT@); }
.ticks { position: relative; height: 1.5rem; font-size: .85rem; font-variant-numeric: tabular-nums; }
.ticks span { position: absolute; transform: translateX(-50%); }
.ticks span:first-child { transform: none; }
.ticks span:last-child { transform: translateX(-100%); }
table { margin-top: .6rem; border-collapse: collapse; }
th, td { padding: .2rem 1.5rem .2rem 0; border-bottom: 1px solid #8886; text-align: left;
         font-variant-numeric: tabular-nums; }
th { font-weight: 600; }
.note { opacity: .75; font-size: .85rem; }
</style>
</head>
<body>
<h1>@TITLE@</h1>
<fieldset><label><input type="checkbox" id="failures"> only what failed</label></fieldset>
<p class="note">Worst first. Drag a picture, or focus it and use the arrow keys, Home and End. FLIP is for @PPD@ pixels
per degree: a 0.7 m wide screen of 3840 pixels, seen from 0.7 m. A dashed box is around wrong pixels that touch.</p>
)html";

/// Each section's first lines.
constexpr const char* reportHeading = R"html(<section class="@PASSED@">
<h2><span class="verdict @CLASS@">@VERDICT@</span>@NAME@</h2>
@OBJECTIONS@)html";

constexpr const char* reportPair = R"html(<p>@SIZE@. Reference: <code>@REFERENCE@</code>.
Test: <code>@TEST@</code>.@NOTE@</p>
<fieldset aria-label="View">
<label><input type="radio" name="view@ID@" value="slider" checked> slider</label>
<label><input type="radio" name="view@ID@" value="flicker"> flicker</label>
</fieldset>
<div class="stage @SMALL@" role="slider" tabindex="0" aria-label="How much of the reference is shown" aria-valuemin="0"
     aria-valuemax="100" aria-valuenow="50">
  <img class="picture" src="@FOLDER@test.png" alt="Test" draggable="false" loading="lazy">
  <img class="picture before" src="@FOLDER@reference.png" alt="Reference" draggable="false" loading="lazy">
  <div class="line"></div>@BOXES@
  <span class="tag left">reference</span>
  <span class="tag right">test</span>
</div>
<p class="note">@MAP@ map</p>
<div class="@SMALL@"><img class="picture" src="@FOLDER@flip.png" alt="@MAP@ map" loading="lazy"></div>
<div class="scale"></div>
<div class="ticks"><span>@LOW@</span><span style="left: 25%">@QUARTER@</span><span style="left: 50%">@HALF@</span>
<span style="left: 75%">@THREE@</span><span style="left: 100%; white-space: nowrap">@HIGH@</span></div>
@ZOOMS@<table>
<tr><th>measure</th><th>value</th><th>expected</th></tr>
@ROWS@</table>
)html";

/// A picture that has no other to be compared with.
constexpr const char* reportAlone = R"html(<p>@WHICH@: <code>@FILE@</code>, @SIZE@.@NOTE@</p>
<div class="@SMALL@"><img class="picture" src="@PICTURE@" alt="@WHICH@" loading="lazy"></div>
)html";

/// Of a sequence.
constexpr const char* reportSteps = R"html(<table>
<tr><th>change to</th><th>reference, mean FLIP</th><th>test</th><th>reference, 99th percentile</th><th>test</th></tr>
@ROWS@</table>
)html";

constexpr const char* reportTail = R"html(
<script>
'use strict';
function show(stage, percent) {
  const split = Math.min(100, Math.max(0, percent));
  stage.style.setProperty('--split', split + '%');
  stage.setAttribute('aria-valuenow', Math.round(split));
}
function follow(event) {
  const box = event.currentTarget.getBoundingClientRect();
  show(event.currentTarget, 100 * (event.clientX - box.left) / box.width);
}
for (const stage of document.querySelectorAll('.stage')) {
  stage.addEventListener('pointerdown', event => { stage.setPointerCapture(event.pointerId); follow(event); });
  stage.addEventListener('pointermove', event => { if (stage.hasPointerCapture(event.pointerId)) follow(event); });
  stage.addEventListener('keydown', event => {
    const split = Number(stage.getAttribute('aria-valuenow')), step = event.shiftKey ? 10 : 1;
    const target = { ArrowLeft: split - step, ArrowDown: split - step, ArrowRight: split + step, ArrowUp: split + step,
                     PageDown: split - 10, PageUp: split + 10, Home: 0, End: 100 }[event.key];
    if (target === undefined) return;
    event.preventDefault();
    show(stage, target);
  });
}
document.addEventListener('change', event => {
  if (event.target.id === 'failures') document.body.classList.toggle('failures', event.target.checked);
  if (event.target.type !== 'radio') return;
  const stage = event.target.closest('section').querySelector('.stage');
  stage.classList.toggle('flicker', event.target.value === 'flicker');
});
setInterval(() => {
  for (const stage of document.querySelectorAll('.flicker')) stage.classList.toggle('blink');
}, 500);
</script>
</body>
</html>
)html";

} // namespace demos
