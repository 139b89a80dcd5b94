"""A kernel as a front end has it: cells are run, and all that comes of them is gathered."""

import queue
import threading
import time

from jupyter_client.manager import start_new_kernel

PATIENCE = 60


class Ran:
    """What came of a cell."""

    def __init__(self):
        self.reply = None
        self.streams = {"stdout": "", "stderr": ""}
        self.shown, self.updated, self.errors = [], [], []
        self.seconds = 0.0

    def take(self, message):
        kind, content = message["msg_type"], message["content"]
        if kind == "stream":
            self.streams[content["name"]] += content["text"]
        elif kind == "display_data":
            self.shown.append(content)
        elif kind == "update_display_data":
            self.updated.append(content)
        elif kind == "error":
            self.errors.append(content)

    def data(self, mime):
        return [content["data"].get(mime) for content in self.shown]

    @property
    def error(self):
        return self.errors[0]["evalue"] if self.errors else None


class Kernel:
    def __init__(self, **settings):
        self.manager, self.client = start_new_kernel(kernel_name="mechanics", **settings)

    def close(self):
        self.client.stop_channels()
        self.manager.shutdown_kernel(now=True)

    def send(self, code, allow_stdin=False):
        return self.client.execute(code, allow_stdin=allow_stdin)

    def run(self, code, interrupt_after=(), lines=None, patience=PATIENCE):
        """lines: those to type where the cell reads; None for a front end that has none."""
        began = time.monotonic()
        number = self.send(code, lines is not None)
        for seconds in interrupt_after:
            timer = threading.Timer(seconds, self.manager.interrupt_kernel)
            timer.daemon = True
            timer.start()
        ran = self.follow(number, lines, patience)
        ran.seconds = time.monotonic() - began
        return ran

    def follow(self, number, lines=None, patience=PATIENCE):
        ran, end = Ran(), time.monotonic() + patience
        while True:
            if lines:
                self.type_line(lines)
            try:
                message = self.client.get_iopub_msg(timeout=0.1)
            except queue.Empty:
                if time.monotonic() > end:
                    raise TimeoutError("the cell did not end")
                continue
            if message["parent_header"].get("msg_id") != number:
                continue
            ran.take(message)
            if message["msg_type"] == "status" and message["content"]["execution_state"] == "idle":
                break
        ran.reply = self.reply_to(number)
        return ran

    def reply_to(self, number):
        while True:
            message = self.client.get_shell_msg(timeout=PATIENCE)
            if message["parent_header"].get("msg_id") == number:
                return message["content"]

    def type_line(self, lines):
        try:
            self.client.get_stdin_msg(timeout=0.02)
        except queue.Empty:
            return
        self.client.input(lines.pop(0))

    def later(self, seconds):
        """What comes after a cell has ended."""
        ran, end = Ran(), time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                ran.take(self.client.get_iopub_msg(timeout=0.1))
            except queue.Empty:
                pass
        return ran
