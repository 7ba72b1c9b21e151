#pragma once

namespace demos {

/// @NAME@ is filled in by report.cpp.
constexpr const char* reportPage = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>@VERDICT@: @REFERENCE@, @TEST@</title>
<style>
:root { color-scheme: dark; }
body { margin: 0 auto; padding: 1.5rem; max-width: max(60rem, @WIDTH@px); background: #1b1d1f; color: #dcdfe2;
       font: 15px/1.5 system-ui, sans-serif; }
h1 { margin: 0 0 .25rem; font-size: 1.3rem; font-weight: 600; }
h2 { margin: 2rem 0 .5rem; font-size: 1rem; font-weight: 600; }
p { margin: .25rem 0; }
code { overflow-wrap: anywhere; }
.verdict { display: inline-block; margin-right: .6rem; padding: .1rem .6rem; border-radius: .3rem; color: #fff; }
.same { background: #1f7a4d; }
.different { background: #b3392f; }
.picture { display: block; width: 100%; @RENDERING@ }
#stage { position: relative; --split: 50%; cursor: ew-resize; touch-action: pan-y; user-select: none; }
#stage:focus-visible { outline: 3px solid #6cb2ff; outline-offset: 3px; }
#before { position: absolute; inset: 0; clip-path: inset(0 calc(100% - var(--split)) 0 0); }
#line { position: absolute; top: 0; bottom: 0; left: var(--split); width: 2px; margin-left: -1px; background: #fff;
        box-shadow: 0 0 3px #000; pointer-events: none; }
#line::after { content: "\2194"; position: absolute; top: 50%; left: 50%; width: 2rem; height: 2rem;
               transform: translate(-50%, -50%); border-radius: 50%; background: #fff; color: #1b1d1f;
               line-height: 2rem; text-align: center; box-shadow: 0 0 3px #000; }
.tag { position: absolute; bottom: .6rem; padding: 0 .5rem; border-radius: .2rem; background: #000a;
       font-size: .85rem; pointer-events: none; }
.left { left: .6rem; }
.right { right: .6rem; }
.scale { height: .8rem; margin-top: .6rem; background: linear-gradient(to right, @GRADIENT@); }
.ticks { position: relative; height: 1.5rem; font-size: .85rem; font-variant-numeric: tabular-nums; }
.ticks span { position: absolute; transform: translateX(-50%); }
.ticks span:first-child { transform: none; }
.ticks span:last-child { transform: translateX(-100%); }
table { border-collapse: collapse; }
th, td { padding: .2rem 1.5rem .2rem 0; border-bottom: 1px solid #3a3e42; text-align: left;
         font-variant-numeric: tabular-nums; }
th { font-weight: 600; }
.note { color: #a4abb2; font-size: .85rem; }
</style>
</head>
<body>
<h1><span class="verdict @CLASS@">@VERDICT@</span>@SIZE@</h1>
@OBJECTIONS@
<p>Reference: <code>@REFERENCE@</code></p>
<p>Test: <code>@TEST@</code></p>

<h2>Reference and test</h2>
<div id="stage" role="slider" tabindex="0" aria-label="How much of the reference is shown" aria-valuemin="0"
     aria-valuemax="100" aria-valuenow="50">
  <img class="picture" src="test.png" alt="Test" draggable="false">
  <img class="picture" id="before" src="reference.png" alt="Reference" draggable="false">
  <div id="line"></div>
  <span class="tag left">reference</span>
  <span class="tag right">test</span>
</div>
<p class="note">Drag, or focus the picture and use the arrow keys, Home and End.@EXPOSURE@</p>

<h2>@FLIP@ map</h2>
<img class="picture" src="flip.png" alt="@FLIP@ map">
<div class="scale"></div>
<div class="ticks"><span>0, unseen</span><span style="left: 25%">0.25</span><span style="left: 50%">0.5</span>
<span style="left: 75%">0.75</span><span style="left: 100%; white-space: nowrap">1, plain</span></div>

<h2>Measures</h2>
<table>
<tr><th>measure</th><th>value</th><th>expected</th></tr>
@ROWS@</table>
<p class="note">FLIP is for @PPD@ pixels per degree: a 0.7 m wide screen of 3840 pixels, seen from 0.7 m.</p>

<script>
'use strict';
const stage = document.getElementById('stage');
let split = 50;
function show(percent) {
  split = Math.min(100, Math.max(0, percent));
  stage.style.setProperty('--split', split + '%');
  stage.setAttribute('aria-valuenow', Math.round(split));
}
function follow(event) {
  const box = stage.getBoundingClientRect();
  show(100 * (event.clientX - box.left) / box.width);
}
stage.addEventListener('pointerdown', event => { stage.setPointerCapture(event.pointerId); follow(event); });
stage.addEventListener('pointermove', event => { if (stage.hasPointerCapture(event.pointerId)) follow(event); });
stage.addEventListener('keydown', event => {
  const step = event.shiftKey ? 10 : 1;
  const target = { ArrowLeft: split - step, ArrowDown: split - step, ArrowRight: split + step, ArrowUp: split + step,
                   PageDown: split - 10, PageUp: split + 10, Home: 0, End: 100 }[event.key];
  if (target === undefined) return;
  event.preventDefault();
  show(target);
});
</script>
</body>
</html>
)html";

} // namespace demos
