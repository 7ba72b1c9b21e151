"""Runs programs that may hang, crash or lose the device: each is one line, not the end."""
import os
import re
import signal
import subprocess
import tempfile
import time
from collections import namedtuple

# What became of a program: its exit code, a negative signal, or None where it was ended at its limit; whether it then went.
Ended = namedtuple("Ended", "code output errors seconds gone")
# What became of a test. `verdict` is one of VERDICTS; `detail` is one line for a reader.
Outcome = namedtuple("Outcome", "program test verdict detail")
VERDICTS = ("passed", "failed", "skipped", "timed out", "crashed", "not run")
BAD = ("failed", "timed out", "crashed")

RESULT = re.compile(r"\[ +(OK|FAILED|SKIPPED) +\] ([^\s,]+)")
OF_RESULT = {"OK": "passed", "FAILED": "failed", "SKIPPED": "skipped"}
SECONDS_TO_DIE = 10


class Running:
    """A process of its own group, whose output files take: a pipe would block a reader behind a process that cannot die."""

    def __init__(self, command, environment):
        self.files = tempfile.TemporaryFile(), tempfile.TemporaryFile()
        self.started = time.monotonic()
        self.process = subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=self.files[0],
                                        stderr=self.files[1], env=environment, start_new_session=True)

    def printed(self, since=0):
        """On its standard output, as bytes, behind the first `since`."""
        file = self.files[0].fileno()
        return os.pread(file, os.fstat(file).st_size - since, since)

    def ended(self, code, gone):
        output, errors = (os.pread(file.fileno(), os.fstat(file.fileno()).st_size, 0).decode(errors="replace") for file in self.files)
        return Ended(code, output, errors, time.monotonic() - self.started, gone)

    def kill(self):
        """False where it stays: in a driver that waits for a GPU that hangs, no signal reaches it."""
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        try:
            self.process.wait(SECONDS_TO_DIE)
        except subprocess.TimeoutExpired:
            return False
        return True


def limited(command, seconds, environment=None):
    """Runs `command`, never longer than that."""
    try:
        running = Running(command, environment)
    except OSError as why:
        return Ended(127, "", f"it cannot be run: {why.strerror}", 0, True)
    code, gone = None, True
    try:
        code = running.process.wait(max(seconds, 0.1))
    except subprocess.TimeoutExpired:
        gone = running.kill()
    except BaseException:
        running.kill()
        raise
    return running.ended(code, gone)


def how(ended):
    """One line on a program that did not end with 0."""
    if ended.code is None:
        return f"did not end in {ended.seconds:.0f} s"
    if ended.code < 0:
        return f"ended by {signal.Signals(-ended.code).name}"
    lines = [line.strip() for line in (ended.errors.strip() or ended.output).splitlines() if line.strip()]
    return f"exit {ended.code}: {lines[-1][:200] if lines else 'it said nothing'}"


def tests_of(program, gtest_filter="*", environment=None):
    """The names of a GoogleTest program's tests; None, and why, where it does not tell. `program` is the words that start it."""
    ended = limited([*program, "--gtest_list_tests", f"--gtest_filter={gtest_filter}"], 60, environment)
    if ended.code != 0:
        return None, how(ended)
    names, suite = [], ""
    for line in ended.output.splitlines():
        word = line.split("#")[0].rstrip()
        if word.endswith(".") and not word.startswith(" "):
            suite = word
        elif word.startswith("  ") and suite:
            names.append(suite + word.strip())
    return [name for name in names if "DISABLED_" not in name], ""


def reason(lines):
    """Of what a failed or skipped test said: where and what, on one line."""
    for i, line in enumerate(lines):
        if re.search(r": (Failure|Skipped)$", line):
            where = os.path.basename(line.rsplit(": ", 1)[0])
            said = " ".join(part.strip() for part in lines[i + 1:i + 4] if part.strip() and not part.startswith("["))
            return f"{where}: {said}"[:200]
    return (lines[-1].strip() if lines else "")[:200]


class Reader:
    """Follows what a GoogleTest program prints."""

    def __init__(self, program):
        self.program, self.read, self.test, self.said, self.at = program, 0, None, [], time.monotonic()
        self.lost = False

    def outcomes(self, running):
        """Of the tests that ended since the last call."""
        new = running.printed(self.read)
        whole = new[:new.rfind(b"\n") + 1]
        self.read += len(whole)
        for line in whole.decode(errors="replace").splitlines():
            if line.startswith("[ RUN      ] "):
                self.test, self.said, self.at = line[13:].strip(), [], time.monotonic()
                continue
            result = RESULT.match(line)
            if self.test and result and result.group(2) == self.test:
                verdict = OF_RESULT[result.group(1)]
                yield Outcome(self.program, self.test, verdict, reason(self.said) if verdict != "passed" else "")
                self.test, self.at = None, time.monotonic()
                self.lost = verdict == "failed" and any("DEVICE_LOST" in said for said in self.said)
                if self.lost:
                    return  # what this process says from now on is the loss's doing
            else:
                self.said.append(line)


def run_tests(program, tests, seconds_each, environment=None, deadline=float("inf"), answers=lambda: True):
    """Yields an Outcome for each of `tests`. They share a process until one hangs or crashes, which ends that process and
    no more: those that are left share the next. `answers` says then whether the device still works; if not, no more run."""
    name, left = os.path.basename(str(program[-1])), list(tests)
    while left:
        if time.monotonic() >= deadline:
            yield from (Outcome(name, test, "not run", "out of time") for test in left)
            return
        running, reader, bad = Running([*program, "--gtest_filter=" + ":".join(left)], environment), Reader(name), ""
        before = len(left)
        try:
            while True:
                over = running.process.poll() is not None
                for outcome in reader.outcomes(running):
                    left.remove(outcome.test)
                    yield outcome
                now = time.monotonic()
                if over or reader.lost:
                    break
                if now - reader.at > seconds_each or now > deadline:
                    bad = "timed out" if now <= deadline else "not run"
                    break
                time.sleep(0.02)
        finally:
            gone = running.kill()
        ended = running.ended(None if bad else running.process.returncode, gone)
        if reader.test:
            left.remove(reader.test)
            detail = {"timed out": f"did not end in {seconds_each:.0f} s", "not run": "out of time"}.get(bad, how(ended))
            yield Outcome(name, reader.test, bad or "crashed", detail)
        elif bad == "timed out" or (len(left) == before and not reader.lost and not bad):
            # Not a test's doing: nothing that is left will fare better.
            yield Outcome(name, "(the program itself)", bad or "crashed", how(ended))
            yield from (Outcome(name, test, "not run", "its program does not run") for test in left)
            return
        elif not left and not reader.lost and ended.code not in (0, 1):
            yield Outcome(name, "(the program itself)", "crashed", f"behind its tests: {how(ended)}")
        if not gone or ((bad == "timed out" or reader.lost or not bad and left) and not answers()):
            yield from (Outcome(name, test, "not run", "the device no longer answers") for test in left)
            return


def counts(outcomes):
    """How many of each verdict, as a dictionary."""
    return {verdict: sum(outcome.verdict == verdict for outcome in outcomes) for verdict in VERDICTS}


def summary(outcomes):
    """The last line of a script: N passed, N failed, N skipped; in brackets those that hung, and what was not run."""
    number = counts(outcomes)
    text = f"{number['passed']} passed, {sum(number[verdict] for verdict in BAD)} failed"
    if number["timed out"]:
        text += f" ({number['timed out']} timed out)"
    text += f", {number['skipped'] + number['not run']} skipped"
    if number["not run"]:
        text += f" ({number['not run']} not run)"
    return text
