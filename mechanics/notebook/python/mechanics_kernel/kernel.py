"""The kernel: requests of a front end, answered by the Racket process.

Output is published by the thread that reads it, under the cell that was run last, so that what a
thread of a program writes later is shown as well.  Coroutines only wait.
"""

import asyncio
import concurrent.futures
import functools
import itertools
import threading

import comm
import ipykernel.ipkernel  # makes comm's messages those of the kernel
import zmq
from ipykernel._version import kernel_protocol_version
from ipykernel.kernelbase import Kernel

from .child import Child

PATIENCE = 3.0

DEAF = ("; the computation does not stop yet: it may be in a library in C\n"
        "; interrupted once more, its process is ended, with all definitions\n")
ENDED = "the process that evaluates cells has ended"
LOST = "; a new one is there, without the definitions: run their cells again"
NOT_BEGUN = "; it was not ready yet: with each cell another start is tried"


class Cell:
    """A cell that is run.  Events come from other threads: (kind, ...)."""

    def __init__(self, number, parent, ident, code, silent):
        self.number, self.parent, self.ident, self.code = number, parent, ident, code
        self.silent, self.child = silent, None
        self.loop = asyncio.get_running_loop()
        self.events = asyncio.Queue()
        self.interrupts = 0
        self.deaf = threading.Event()
        self.processes = set()

    def put(self, *event):
        self.loop.call_soon_threadsafe(self.events.put_nowait, event)


class MechanicsKernel(Kernel):
    implementation = "mechanics"
    implementation_version = "0.3"
    banner = "mechanics: classical mechanics in the language of SICM"
    language_info = {"name": "racket", "mimetype": "text/x-racket", "file_extension": ".rkt",
                     "codemirror_mode": "scheme", "pygments_lexer": "racket"}

    def __init__(self, **settings):
        super().__init__(**settings)
        self.numbers = itertools.count(1)
        self.asked = {}
        self.displays, self.explorations = {}, {}
        self.cell = self.frame = None
        self.last_request = {}
        self.progress_shown = None
        self.shutting_down = False
        self.starting = threading.Lock()
        self.turn = threading.Lock()
        comms = comm.get_comm_manager()
        for kind in ("comm_open", "comm_msg", "comm_close"):
            self.shell_handlers[kind] = getattr(comms, kind)
        self.start_child()

    def start_child(self):
        self.child = Child(self.receive, self.write, self.child_ended)

    def replace_child(self, child):
        """Another in the place of one that has ended."""
        try:
            self.start_child()
        except OSError as problem:
            child.ready, child.end_words = False, f"{ENDED}, and no other starts: {problem}"

    @property
    def kernel_info(self):
        """Without a debugger, which would be loaded to be offered."""
        return {"protocol_version": kernel_protocol_version, "implementation": self.implementation,
                "implementation_version": self.implementation_version,
                "language_info": self.language_info, "banner": self.banner,
                "help_links": self.help_links,
                "supported_features": ["kernel subshells"] * self._supports_kernel_subshells}

    # From the Racket process, on threads of its own

    def receive(self, child, message):
        try:
            self.take(child, message)
        except Exception as problem:
            self.write_problem(problem)

    def write_problem(self, problem):
        self.write("stderr", f"; the kernel failed: {type(problem).__name__}: {problem}\n")

    def take(self, child, message):
        kind, cell = message.pop("kind"), self.cell
        if kind == "ready":
            child.ready = True
        elif kind == "stream":
            self.write(message["name"], message["text"])
        elif kind == "shown":
            self.show(message["data"], message.get("display"), message.get("update", False))
        elif kind == "interaction":
            self.show_interaction(child, message)
        elif kind == "exploration":
            self.show_exploration(child, message)
        elif kind == "progress":
            self.show_progress(message["text"])
        elif kind == "input" and cell:
            cell.put("input")
        elif kind == "done":
            self.answer(message.pop("id"), message)

    def answer(self, number, message):
        cell = self.cell
        if number == self.frame:
            self.frame = None
        if cell and number == cell.number:
            cell.put("done", message)
        else:
            future = self.asked.pop(number, None)
            if future and not future.done():
                try:
                    future.set_result(message)
                except concurrent.futures.InvalidStateError:  # cancelled just now
                    pass

    def child_ended(self, child, words):
        """One that was never ready is replaced by the next cell: else this could go on forever."""
        if self.shutting_down:
            return
        with self.starting:
            child.end_words = words
            self.frame = self.progress_shown = None
            for number in list(self.asked):
                self.answer(number, {"status": "error"})
            cell = self.cell
            if child.ready:
                self.replace_child(child)
        if cell and cell.child is child:
            cell.put("ended", child.end_words)
        elif child.ready:
            self.write("stderr", f"; {words}\n{LOST}\n")

    def publish(self, kind, content):
        cell = self.cell
        if cell and cell.silent:
            return
        self.session.send(self.iopub_socket, kind, content, parent=self.last_request,
                          ident=self._topic(kind))

    def write(self, name, text):
        self.publish("stream", {"name": name, "text": text})

    def show(self, data, display=None, update=False):
        explored = self.explorations.get(display)
        content = {"data": explored.page(data) if explored else data, "metadata": {}}
        if display:
            content["transient"] = {"display_id": display}
            update = self.still_shown(display) and update
        self.publish("update_display_data" if update else "display_data", content)

    def still_shown(self, display):
        """Not where an earlier run of this cell showed it: that output is gone."""
        here = (self.last_request.get("metadata") or {}).get("cellId")
        run = self.last_request["header"]["msg_id"]
        cell, last = self.displays.get(display, (None, None))
        gone = last is None or (cell == here and last != run)
        if gone:
            self.displays[display] = (here, run)
        return not gone

    def show_progress(self, text):
        """One line, which changes."""
        first = self.progress_shown is None
        if first and not text:
            return
        if first:
            self.progress_shown = f"progress-{next(self.numbers)}"
        self.show({"text/plain": text}, self.progress_shown, not first)
        if not text:
            self.progress_shown = None

    # Interactions

    def show_interaction(self, child, message):
        """Widgets are loaded with the first one."""
        from .interaction import Interaction

        shown = Interaction(message, self.worker, child)
        self.show(shown.bundle(message["data"]))

    def show_exploration(self, child, message):
        """The picture, which is shown anew in its place, and its buttons."""
        from .exploration import Exploration

        display = message["display"]
        shown = self.explorations[display] = Exploration(
            message, self.worker, child,
            lambda data: self.publish("update_display_data", {
                "data": shown.page(data), "metadata": {}, "transient": {"display_id": display}}))
        self.show(message["data"], display)
        self.show(shown.bundle())

    @functools.cached_property
    def worker(self):
        from .interaction import Worker

        def ask(interaction, id, question):
            if interaction.child is not self.child:
                return None
            self.frame = id
            return self.asking(id, **question)

        return Worker(ask, lambda id: self.child.send(do="break", id=id),
                      lambda: next(self.numbers), self.write_problem)

    # Cells

    async def do_execute(self, code, silent, store_history=True, user_expressions=None,
                         allow_stdin=False):
        """One cell after the other, those of subshells too, which are on threads of their own."""
        while not self.turn.acquire(blocking=False):
            await asyncio.sleep(0.02)
        try:
            return await self.run_cell(code, silent, allow_stdin)
        finally:
            self.turn.release()

    async def run_cell(self, code, silent, allow_stdin):
        cell = Cell(next(self.numbers), self.get_parent("shell"), self._parent_ident["shell"], code,
                    silent)
        if not silent:
            self.last_request = cell.parent
        with self.starting:
            cell.child = child = self.child
            self.cell = cell
            if child.end_words:
                self.replace_child(child)
        try:
            cell.processes = child.started()
            if child.end_words or not child.send(do="cell", id=cell.number, code=code):
                cell.put("ended", child.end_words or ENDED)
            return await self.follow(cell, allow_stdin, silent)
        finally:
            self.cell = None

    async def follow(self, cell, allow_stdin, silent):
        while True:
            kind, *rest = await cell.events.get()
            if kind == "input":
                if allow_stdin:
                    line = await self.read_line(cell)
                    if line is not None and not cell.child.send(do="input", text=line):
                        cell.put("ended", cell.child.end_words or ENDED)
                else:
                    self.write("stderr", "; this front end has no lines to read\n")
                    cell.child.send(do="break", id=cell.number)
            elif kind == "ended":
                message = f"{rest[0]}\n{LOST if cell.child.ready else NOT_BEGUN}"
                return self.failed(cell, {"message": message, "line": None}, silent)
            else:
                if cell.interrupts:
                    cell.child.end_started(cell.processes)
                if rest[0]["status"] == "ok":
                    return {"status": "ok", "execution_count": self.execution_count,
                            "payload": [], "user_expressions": {}}
                return self.failed(cell, rest[0], silent)

    def failed(self, cell, failure, silent):
        message, line = failure["message"], failure["line"]
        name = "interrupted" if failure.get("interrupted") else "error"
        content = {"ename": name, "evalue": message, "traceback": marked(message, line, cell.code)}
        if not silent:
            self.publish("error", content)
        return {"status": "error", "execution_count": self.execution_count, **content}

    async def read_line(self, cell):
        """A line that is typed, or None if the cell is interrupted or has ended."""
        before = cell.interrupts
        self.drop_old_lines()
        self.session.send(self.stdin_socket, "input_request", {"prompt": "", "password": False},
                          parent=cell.parent, ident=cell.ident)
        while cell.interrupts == before and cell.events.empty():
            try:
                _, reply = self.session.recv(self.stdin_socket, mode=zmq.NOBLOCK)
                if reply:
                    return reply["content"]["value"]
            except (zmq.ZMQError, ValueError, KeyError):
                pass
            await asyncio.sleep(0.02)
        return None

    def drop_old_lines(self):
        try:
            while True:
                self.stdin_socket.recv_multipart(zmq.NOBLOCK)
        except zmq.ZMQError:
            pass

    # Interrupts come on the thread of the control channel

    async def interrupt_request(self, stream, ident, parent):
        cell, frame = self.cell, self.frame
        if frame:
            self.child.send(do="break", id=frame)
        if cell:
            cell.interrupts += 1
            if cell.interrupts > 1 and cell.deaf.is_set():
                cell.child.kill("the process that evaluates cells was ended")
            else:
                cell.child.send(do="break", id=cell.number)
                self.watch_interrupt(cell)
        self.session.send(stream, "interrupt_reply", {"status": "ok"}, parent, ident=ident)

    def watch_interrupt(self, cell):
        def tell():
            if self.cell is cell:
                cell.deaf.set()
                self.write("stderr", DEAF)

        timer = threading.Timer(PATIENCE, tell)
        timer.daemon = True
        timer.start()

    async def do_shutdown(self, restart):
        self.shutting_down = True
        self.child.end()
        return {"status": "ok", "restart": restart}

    # Questions of an editor

    def asking(self, number, /, **question):
        """A future of the answer."""
        future = self.asked[number] = concurrent.futures.Future()
        if not self.child.send(id=number, **question):
            self.answer(number, {"status": "error"})
        return future

    async def ask(self, **question):
        return await asyncio.wrap_future(self.asking(next(self.numbers), **question))

    async def do_complete(self, code, cursor_pos):
        found = await self.ask(do="complete", code=code, cursor=cursor_pos)
        return {"status": "ok", "matches": found.get("matches", []),
                "cursor_start": found.get("start", cursor_pos),
                "cursor_end": found.get("end", cursor_pos),
                "metadata": {"_jupyter_types_experimental": [
                    {"text": name, "signature": signature, "start": found["start"],
                     "end": found["end"], "type": "function" if signature else ""}
                    for name, signature in zip(found.get("matches", ()), found.get("signatures", ()))]}}

    async def do_inspect(self, code, cursor_pos, detail_level=0, omit_sections=()):
        found = await self.ask(do="describe", code=code, cursor=cursor_pos)
        return {"status": "ok", "found": found.get("found", False),
                "data": found.get("data", {}), "metadata": {}}

    async def do_is_complete(self, code):
        found = await self.ask(do="completeness", code=code)
        status = found.get("status", "unknown")
        return {"status": status, **({"indent": "  "} if status == "incomplete" else {})}


def marked(message, line, code):
    """The message, and beneath it the line of the cell that failed, where it has several."""
    lines = code.splitlines()
    traceback = [f"\x1b[31m{message}\x1b[0m"]
    if line and len(lines) > 1 and line <= len(lines):
        traceback.append(f"\x1b[2min line {line}:\x1b[0m  {lines[line - 1].strip()}")
    return traceback
