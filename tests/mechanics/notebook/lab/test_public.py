"""The public tests of kernels, and the tools that run and convert notebooks."""

import pathlib
import tempfile
import unittest

import jupyter_kernel_test
import nbformat
from nbclient import NotebookClient
from nbconvert import HTMLExporter, LatexExporter

from browser import notebook


class PublicTests(jupyter_kernel_test.KernelTests):
    kernel_name = "mechanics"
    language_name = "racket"
    file_extension = ".rkt"
    code_hello_world = '(display "hello, world")'
    code_stderr = '(display "error" (current-error-port))'
    code_execute_result = []
    code_display_data = [{"code": "(/ 'a 'b)", "mime": "text/latex"}]
    code_generate_error = "(car 5)"
    code_inspect_sample = "Gamma"
    completion_samples = [{"text": "Lagrange-e", "matches": {"Lagrange-equations",
                                                          "Lagrange-equations-first-order"}}]
    complete_code_samples = ["(+ 1 2)", "(define x 3)"]
    incomplete_code_samples = ["(+ 1", "(define (f x)"]
    invalid_code_samples = [")"]


class Tools(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = notebook(["(* 1/2 'm (square 'v))", "(verify-equal 'a 'b)",
                             "(interact ([k 1 3]) (* k 'a))"])
        NotebookClient(cls.made, timeout=120, kernel_name="mechanics").execute()

    def test_run_without_a_front_end(self):
        data = [cell.outputs[-1]["data"] for cell in self.made.cells]
        self.assertEqual(data[0]["text/plain"], "(* 1/2 m (expt v 2))")
        self.assertIn("refuted", data[1]["text/html"])
        self.assertEqual(data[2]["text/plain"], "a")

    def test_convert_to_a_page_and_for_LaTeX(self):
        page, _ = HTMLExporter().from_notebook_node(self.made)
        self.assertIn("refuted: the residual is not zero", page)
        self.assertIn(r"\frac{1}{2}\,m\,v^{2}", page)
        text, _ = LatexExporter().from_notebook_node(self.made)
        self.assertIn(r"\frac{1}{2}\,m\,v^{2}", text)

    def test_open_again_untrusted(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "again.ipynb"
            nbformat.write(self.made, path)
            again = nbformat.read(path, as_version=4)
        self.assertNotIn("<script", again.cells[1].outputs[-1]["data"]["text/html"])
