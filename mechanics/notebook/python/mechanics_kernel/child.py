"""The Racket process that evaluates cells, and the descriptors of its protocol.

Its messages, and what it or a program of a cell writes on the standard descriptors, are handed to
procedures by threads of their own.  It leads a session: what a cell started can be ended with it.
"""

import codecs
import json
import os
import resource
import signal
import subprocess
import threading
import time

import psutil

MAIN = "mechanics/notebook/cell-process"
MEGABYTE = 1 << 20


def memory_limit():
    """Bytes that the process may take: MECHANICS_KERNEL_MEMORY, such as 500M or 2G."""
    text = os.environ.get("MECHANICS_KERNEL_MEMORY", "2G").strip().upper().removesuffix("B")
    units = {"K": 1 << 10, "M": MEGABYTE, "G": 1 << 30}
    try:
        return int(float(text[:-1]) * units[text[-1]] if text[-1:] in units else float(text))
    except (ValueError, OverflowError):
        return 2 << 30


class Child:
    """On threads: receive(child, message), write(name, text), and ended(child, words) once.

    The owner notes in ready that it has begun, and in end_words how it ended.
    """

    def __init__(self, receive, write, ended):
        self.receive, self.ended = receive, ended
        self.limit = memory_limit()
        self.reason = self.end_words = None
        self.ready = False
        self.sending = threading.Lock()
        self.process, self.requests, self.answers = self._start()
        self.readers = [self._thread(self._read_stream, pipe, name, write)
                        for pipe, name in ((self.process.stdout, "stdout"),
                                           (self.process.stderr, "stderr"))]
        self._thread(self._read_answers)
        self._thread(self._watch_memory)

    def _start(self):
        from_us, requests = os.pipe()
        answers, to_us = os.pipe()
        racket = os.environ.get("MECHANICS_RACKET", "racket")
        process = subprocess.Popen(
            [racket, "-l", MAIN, "--", str(from_us), str(to_us)],
            pass_fds=[from_us, to_us], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, start_new_session=True)
        os.close(from_us)
        os.close(to_us)
        self._limit_data(process.pid)
        return process, os.fdopen(requests, "wb"), os.fdopen(answers, "rb")

    def _limit_data(self, pid):
        """Behind the watch, for a cell that takes memory faster than it looks."""
        if hasattr(resource, "prlimit"):
            most = self.limit + 1024 * MEGABYTE
            try:
                resource.prlimit(pid, resource.RLIMIT_DATA, (most, most))
            except (OSError, ValueError, OverflowError):
                pass

    @staticmethod
    def _thread(target, *arguments):
        thread = threading.Thread(target=target, args=arguments, daemon=True)
        thread.start()
        return thread

    # Messages

    def send(self, **message):
        """False where the process has ended."""
        text = json.dumps(message).encode()
        try:
            with self.sending:
                self.requests.write(b"%d\n" % len(text) + text)
                self.requests.flush()
            return True
        except (OSError, ValueError):
            return False

    def _read_answers(self):
        while length := self.answers.readline():
            self.receive(self, json.loads(self.answers.read(int(length))))
        self.process.wait()
        self._kill_group()
        for reader in self.readers:
            reader.join(0.5)
        self.ended(self, self.reason or self._words())

    def _words(self):
        code = self.process.returncode
        if code == -signal.SIGABRT:
            return "the process that evaluates cells ended for want of memory"
        how = f"by signal {-code}" if code < 0 else f"with code {code}"
        return f"the process that evaluates cells ended {how}"

    @staticmethod
    def _read_stream(pipe, name, write):
        decoder = codecs.getincrementaldecoder("utf-8")("replace")
        data = True
        while data:
            data = os.read(pipe.fileno(), 65536)
            if text := decoder.decode(data, final=not data):
                write(name, text)

    # Ends

    def _watch_memory(self):
        try:
            process = psutil.Process(self.process.pid)
            while self.process.poll() is None:
                taken = process.memory_info().rss
                if taken > self.limit:
                    self.kill(f"the cell took more than {self.limit // MEGABYTE} MB of memory "
                              "(MECHANICS_KERNEL_MEMORY sets the limit)")
                time.sleep(0.2)
        except psutil.Error:
            pass

    def started(self):
        """The processes that cells have started and that still run."""
        try:
            return set(psutil.Process(self.process.pid).children(recursive=True))
        except psutil.Error:
            return set()

    def end_started(self, before=frozenset()):
        for process in self.started() - before:
            try:
                process.kill()
            except psutil.Error:
                pass

    def kill(self, reason):
        self.reason = reason
        self.end_started()
        self._kill_group()

    def _kill_group(self):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except OSError:
            pass

    def end(self):
        self.kill("the kernel was shut down")
        self.process.wait()
