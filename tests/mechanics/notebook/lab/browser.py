"""JupyterLab in a real browser: a server of its own, a notebook made of the given cells, a page."""

import atexit
import functools
import os
import pathlib
import secrets
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request

import nbformat
from playwright.sync_api import sync_playwright

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))),
                None)
OPTIONS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
           "--disable-component-update", "--disable-sync"]


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


def notebook(cells):
    made = nbformat.v4.new_notebook()
    made.metadata["kernelspec"] = {"name": "mechanics", "display_name": "mechanics",
                                   "language": "racket"}
    made.cells = [nbformat.v4.new_code_cell(code) for code in cells]
    return made


@functools.cache
def playwright():
    """One for all: a second one cannot be started."""
    started = sync_playwright().start()
    atexit.register(started.stop)
    return started


class Lab:
    """A server, and a browser at it."""

    def __init__(self, width=1200, height=1600):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.port, self.token = free_port(), secrets.token_hex(8)
        environment = dict(os.environ, JUPYTER_CONFIG_DIR=str(self.folder / ".config"),
                           JUPYTERLAB_SETTINGS_DIR=str(self.folder / ".settings"))
        self.server = subprocess.Popen(
            [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root",
             "--ServerApp.ip=127.0.0.1", "--KernelManager.transport=ipc",
             f"--ServerApp.port={self.port}",
             f"--ServerApp.root_dir={self.folder}", f"--IdentityProvider.token={self.token}",
             "--LabApp.news_url=None"],
            env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait_for_server()
        self.browser = playwright().chromium.launch(executable_path=CHROMIUM, args=OPTIONS)
        self.page = self.browser.new_page(viewport={"width": width, "height": height})

    def address(self, path):
        return f"http://127.0.0.1:{self.port}/{path}?token={self.token}"

    def wait_for_server(self):
        for _ in range(300):
            try:
                urllib.request.urlopen(self.address("api"))
                return
            except OSError:
                time.sleep(0.2)
        raise TimeoutError("JupyterLab did not start")

    def open(self, name, cells):
        nbformat.write(notebook(cells), self.folder / name)
        self.page.goto(self.address(f"lab/tree/{name}"))
        self.page.wait_for_selector(".jp-Notebook .jp-Cell", timeout=120_000)
        self.page.wait_for_selector(".jp-Notebook-ExecutionIndicator[data-status=idle]",
                                    timeout=120_000, state="attached")
        # the session is known a little later than its kernel
        time.sleep(3)

    def menu(self, title, command):
        self.page.click(f".lm-MenuBar-itemLabel:text-is('{title}')")
        self.page.click(f".lm-Menu-itemLabel:text-is('{command}')")

    def run_all(self):
        self.menu("Run", "Run All Cells")

    def cell(self, number):
        return self.page.locator(".jp-Notebook .jp-CodeCell").nth(number)

    def close(self):
        self.browser.close()
        self.server.terminate()
        try:
            self.server.wait(30)
        except subprocess.TimeoutExpired:
            self.server.kill()
        shutil.rmtree(self.folder, ignore_errors=True)


def median(xs):
    return sorted(xs)[len(xs) // 2]
