"""Runs the command in a folder of its own, and checks promises that hold for every command line."""
import contextlib
import hashlib
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import time

TIME_LIMIT = 120  # seconds: more is a hang
CONTROL = re.compile(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]")


class Broken(Exception):
    """A promise of docs/reliability.md is broken."""


class Outcome:
    def __init__(self, words, code, out, err):
        self.words, self.code, self.out, self.err = words, code, out, err

    def require(self, holds, what):
        if not holds:
            raise Broken(f"{what}\n  {self}")

    def __str__(self):
        return f"tamis {self.words!r}\n  code {self.code}\n  out {self.out[-600:]!r}\n  err {self.err[-600:]!r}"


def refuse_constant(text):
    raise ValueError(f"{text} is not JSON")


def check_texts(outcome):
    for text in (outcome.out, outcome.err):
        try:
            outcome.require(not CONTROL.search(text.decode()), "a control character is printed")
        except UnicodeDecodeError:
            outcome.require(False, "what is printed is no UTF-8")


def check(outcome):
    """Check the promises that hold for every command line with open streams."""
    outcome.require(outcome.code in (0, 1, 2), "exit code is none of 0, 1, 2")
    check_texts(outcome)
    lines = outcome.err.decode().splitlines()
    errors = [line for line in lines if line.startswith("tamis: ")]
    outcome.require(len(errors) == (outcome.code == 2), "not one sentence for an error")
    outcome.require(all(line.startswith(("tamis: ", "note: ")) for line in lines), "stderr has a line of neither kind")
    if outcome.code != 2 and "--json" in outcome.words and "--help" not in outcome.words:
        try:
            json.loads(outcome.out, parse_constant=refuse_constant)
        except ValueError as error:
            outcome.require(False, f"no JSON: {error}")


class Folder:
    """A folder with a copy of the inputs, in which the command runs."""

    def __init__(self, tamis, path):
        self.tamis, self.path = tamis, pathlib.Path(path)

    def start(self, words, out=subprocess.PIPE, err=subprocess.PIPE, limits=(), closed=()):
        def prepare():
            for limit, value in limits:
                resource.setrlimit(limit, (value, value))
            for stream in closed:
                os.close(stream)

        environment = dict(os.environ, PATH=f"{self.path}/bin:{os.environ['PATH']}")
        return subprocess.Popen([self.tamis, *words], cwd=self.path, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                env=environment, preexec_fn=prepare, start_new_session=True)

    def run(self, words, **streams):
        return self.finish(self.start(words, **streams), words)

    def finish(self, process, words):
        try:
            out, err = process.communicate(timeout=TIME_LIMIT)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            raise Broken(f"no end after {TIME_LIMIT} s\n  tamis {words!r}") from None
        return Outcome(words, process.returncode, out or b"", err or b"")

    def run_and_check(self, words, **streams):
        outcome = self.run(words, **streams)
        check(outcome)
        return outcome

    def interrupt(self, words, number, seconds):
        """Run the command, and send it a signal after some seconds, unless it has ended before."""
        process = self.start(words)
        time.sleep(seconds)
        with contextlib.suppress(ProcessLookupError):
            process.send_signal(number)
        return self.finish(process, words)

    def files(self):
        return {path for path in self.path.rglob("*") if not path.is_dir()}

    def unfinished(self):
        return [path for path in self.files() if ".part" in path.name]

    def require_nothing_unfinished(self, outcome):
        outcome.require(not self.unfinished(), f"left behind: {self.unfinished()}")

    def contents(self):
        """Return a hash of every file: if it is the same before and after, no file was changed."""
        return {path: hashlib.sha256(path.read_bytes()).digest() for path in self.files() if path.is_file()}
