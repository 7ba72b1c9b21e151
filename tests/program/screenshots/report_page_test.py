"""report_page_test.py PROGRAM: the report of 200 tests in headless Chromium, as a person uses it: by mouse and by keyboard, light
and dark. Ends with 77, which skips the test, where there is no Chromium."""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

PICTURES, FAILED = 200, 20


def write_png(file, grey):
    """40 x 24 of one grey."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = (b"\0" + bytes([grey] * 3 * 40)) * 24
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 40, 24, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def write_report(program, folder):
    for name in ("ref", "out"):
        (folder / name).mkdir()
    for i in range(PICTURES):
        write_png(folder / f"ref/test{i}.png", 120)
        write_png(folder / f"out/test{i}.png", 120 + 4 * (i + 1) if i < FAILED else 120)
    done = subprocess.run([program, "compare", "ref", "out", "--tolerant", "--report", "report"], cwd=folder,
                          capture_output=True, text=True)
    assert done.returncode == 1, done.stderr
    return folder / "report/index.html"


class Browser:
    """Chromium, by the pipes of its DevTools protocol: JSON, each message ended by a zero."""

    def __init__(self, program, profile):
        to_read, self.to = os.pipe()
        self.answers, to_write = os.pipe()
        self.process = subprocess.Popen(
            ["sh", "-c", 'exec "$@" 3<&%d 4>&%d' % (to_read, to_write), "sh", program, "--headless=new", "--no-sandbox",
             "--disable-gpu", "--hide-scrollbars", "--remote-debugging-pipe", f"--user-data-dir={profile}",
             "--window-size=1200,900", "about:blank"],
            pass_fds=(to_read, to_write), stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self.buffer, self.number, self.session = b"", 0, None
        self.events = []
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(domain + ".enable")

    def receive(self):
        while b"\0" not in self.buffer:
            data = os.read(self.answers, 1 << 16)
            assert data, "Chromium ended"
            self.buffer += data
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                assert "error" not in answer, answer
                return answer["result"]
            self.events.append(answer)

    def open(self, page):
        self.call("Page.navigate", url=page.as_uri())
        while not any(event["method"] == "Page.loadEventFired" for event in self.events):
            self.events.append(self.receive())

    def value(self, expression):
        return self.call("Runtime.evaluate", expression=expression, returnByValue=True)["result"].get("value")

    def mouse(self, kind, x, y):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)

    def click(self, selector):
        """In the middle of what is there, as a person would."""
        self.value(f"document.querySelector({selector!r}).scrollIntoView({{block: 'center'}})")
        x, y = self.value(f"(r => [r.x + r.width / 2, r.y + r.height / 2])(document.querySelector({selector!r})"
                          ".getBoundingClientRect())")
        self.mouse("mousePressed", x, y)
        self.mouse("mouseReleased", x, y)

    def key(self, name):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=name, code=name,
                      windowsVirtualKeyCode={"ArrowRight": 39, "End": 35, "Tab": 9, " ": 32}.get(name, 0))

    def problems(self):
        bad = []
        for event in self.events:
            parameters = event.get("params", {})
            if event["method"] == "Runtime.exceptionThrown":
                bad.append(parameters["exceptionDetails"]["text"])
            if event["method"] == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
                bad.append(parameters["entry"]["text"])
            if event["method"] == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning"):
                bad.append(str(parameters["args"]))
        return bad


SHOWN = "[...document.querySelectorAll('section')].filter(s => s.offsetParent !== null).length"
SPLIT = "Number(document.querySelector('.stage').getAttribute('aria-valuenow'))"


def check(browser):
    expect = {}
    expect["all tests are shown"] = browser.value(SHOWN) == PICTURES
    first = browser.value("[...document.querySelectorAll('section')].map(s => s.className)")
    expect["what failed comes first"] = first == ["failed"] * FAILED + ["passed"] * (PICTURES - FAILED)
    loaded = browser.value("[...document.images].filter(i => i.complete && i.naturalWidth > 0).length")
    expect["pictures are loaded where they are looked at"] = 0 < loaded < 3 * PICTURES / 2

    x, y, width = browser.value("(r => [r.x, r.y + 40, r.width])(document.querySelector('.stage').getBoundingClientRect())")
    browser.mouse("mousePressed", x + 0.5 * width, y)
    browser.mouse("mouseMoved", x + 0.2 * width, y)
    browser.mouse("mouseReleased", x + 0.2 * width, y)
    expect["the slider follows the mouse"] = abs(browser.value(SPLIT) - 20) <= 1
    clip = browser.value("getComputedStyle(document.querySelector('.before')).clipPath")
    expect["and parts the pictures"] = "80" in clip

    browser.value("document.querySelector('.stage').focus()")
    browser.key("ArrowRight")
    expect["the slider follows the arrow keys"] = abs(browser.value(SPLIT) - 21) <= 1
    browser.key("End")
    expect["and End"] = browser.value(SPLIT) == 100
    outline = browser.value("getComputedStyle(document.querySelector('.stage')).outlineStyle")
    expect["the focus is seen"] = outline == "solid"

    zooms = browser.value("[...document.querySelector('section').querySelectorAll('.zooms div')].map(d => d.offsetWidth)")
    expect["the worst region is zoomed three times"] = len(zooms) == 3 and min(zooms) >= 100

    browser.click("input[value=flicker]")
    expect["flicker is chosen"] = browser.value("document.querySelector('.stage').classList.contains('flicker')")

    seen = ("(stage => ['left', 'right'].map(side => getComputedStyle(stage.querySelector('.tag.' + side)).visibility))"
            "(document.querySelector('.stage'))")
    blink = "document.querySelector('.stage').classList.%s('blink')"
    tags = [browser.value(f"(() => {{ {blink % how}; return {seen}; }})()") for how in ("remove", "add")]
    expect["it names the picture that is seen"] = tags == [["visible", "hidden"], ["hidden", "visible"]]

    browser.click("#failures")
    expect["the filter leaves what failed"] = browser.value(SHOWN) == FAILED
    browser.value("document.querySelector('#failures').focus()")
    browser.key(" ")
    expect["and goes by keyboard"] = browser.value(SHOWN) == PICTURES

    colors = {}
    for scheme in ("light", "dark"):
        browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        colors[scheme] = browser.value("(s => [s.backgroundColor, s.color])(getComputedStyle(document.body))")
    expect["it is light or dark as the reader is"] = colors["light"] == colors["dark"][::-1] or (
        colors["light"][0] != colors["dark"][0] and colors["light"][1] != colors["dark"][1])
    expect[f"the console is silent: {browser.problems()}"] = not browser.problems()
    return expect


def main():
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not chromium:
        print("skipped: no chromium, which apt-get install chromium brings")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        page = write_report(os.path.abspath(sys.argv[1]), pathlib.Path(folder))
        browser = Browser(chromium, folder + "/profile")
        try:
            browser.open(page)
            expect = check(browser)
            if len(sys.argv) > 2:
                import base64
                shot = browser.call("Page.captureScreenshot", format="png")["data"]
                pathlib.Path(sys.argv[2]).write_bytes(base64.b64decode(shot))
        finally:
            browser.process.kill()
            browser.process.wait()
    for what, held in expect.items():
        print(("     " if held else "NOT: ") + what)
    return 0 if all(expect.values()) else 1


sys.exit(main())
