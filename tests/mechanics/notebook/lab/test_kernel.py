"""The kernel, by its own protocol: a test for each thing that goes wrong in kernels."""

import os
import signal
import time
import unittest

import psutil

from client import Kernel

FORMULA = "text/latex"
PLAIN = "text/plain"


class KernelTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kernel = Kernel()

    @classmethod
    def tearDownClass(cls):
        cls.kernel.close()

    def run_cell(self, code, **settings):
        return self.kernel.run(code, **settings)

    def works(self):
        """The next cell works."""
        self.assertEqual(self.run_cell("(+ 'a 'a)").data(PLAIN), ["(* 2 a)"])

    def python(self):
        return psutil.Process(self.kernel.manager.provisioner.pid)

    def child(self):
        return next(p for p in self.python().children() if "racket" in p.name())


class Results(KernelTest):
    def test_formula_is_typeset(self):
        ran = self.run_cell("(/ 'a 'theta_1)")
        self.assertEqual(ran.data(FORMULA), [r"$\displaystyle \frac{a}{\theta_{1}}$"])
        self.assertEqual(ran.data(PLAIN), ["(/ a theta_1)"])
        self.assertEqual(ran.reply["status"], "ok")

    def test_names_in_chinese(self):
        self.assertEqual(self.run_cell("(define (力 m) (* m 'θ))\n(力 2)").data(PLAIN), ["(* 2 θ)"])

    def test_error_marks_its_line(self):
        ran = self.run_cell("(display \"so far\")\n(car 5)")
        self.assertEqual(ran.streams["stdout"], "so far")
        self.assertIn("given: 5", ran.error)
        self.assertIn("in line 2:", ran.errors[0]["traceback"][-1])
        self.assertIn("(car 5)", ran.errors[0]["traceback"][-1])
        self.assertEqual(ran.reply["status"], "error")
        self.works()

    def test_cells_behind_a_failed_one_are_left(self):
        first = self.kernel.send("(begin (sleep 0.5) (car 5))")
        second = self.kernel.send("(display \"not run\")")
        self.assertIsNotNone(self.kernel.follow(first).error)
        ran = self.kernel.follow(second)
        self.assertEqual(ran.reply["status"], "aborted")
        self.works()

    def test_two_cells_queued(self):
        first = self.kernel.send("(begin (sleep 0.3) (display \"one\"))")
        second = self.kernel.send("(display \"two\")")
        self.assertEqual(self.kernel.follow(first).streams["stdout"], "one")
        self.assertEqual(self.kernel.follow(second).streams["stdout"], "two")

    def test_bad_input_in_words(self):
        for code, words in [("(+ 1", "ends inside a form"), ("x = 3", "(define x 3)"),
                            ("#lang racket", "leave the line #lang out"),
                            ("(module+ test 1)", "part of a file"),
                            ("(exit)", "menu Kernel"), ("no-such-name", "undefined")]:
            with self.subTest(code):
                self.assertIn(words, self.run_cell(code).error)
                self.works()

    def test_completion_and_help(self):
        client = self.kernel.client
        reply = self.kernel.reply_to(client.complete("(Lagrange-e", 11))
        self.assertIn("Lagrange-equations", reply["matches"])
        self.assertEqual((reply["cursor_start"], reply["cursor_end"]), (1, 11))
        reply = self.kernel.reply_to(client.inspect("(Gamma q)", 3))
        self.assertIn("(Gamma q [n])", reply["data"][PLAIN])
        reply = self.kernel.reply_to(client.is_complete("(+ 1"))
        self.assertEqual(reply["status"], "incomplete")


class Streams(KernelTest):
    def test_both(self):
        ran = self.run_cell('(display "out") (display "err" (current-error-port))')
        self.assertEqual(ran.streams, {"stdout": "out", "stderr": "err"})

    def test_ten_megabytes_in_a_line(self):
        ran = self.run_cell("(display (make-string 10000000 #\\a))")
        self.assertEqual(len(ran.streams["stdout"]), 1_000_000)
        self.assertIn("9000000 more bytes", ran.streams["stderr"])

    def test_a_million_lines(self):
        ran = self.run_cell("(for ([i 1000000]) (displayln i))")
        self.assertTrue(ran.streams["stdout"].startswith("0\n1\n2\n"))
        self.assertIn("more bytes of output are left out", ran.streams["stderr"])
        self.works()

    def test_late_thread(self):
        self.run_cell('(define t (thread (lambda () (sleep 0.5) (display "late"))))')
        self.assertEqual(self.kernel.later(1.5).streams["stdout"], "late")

    def test_output_from_C(self):
        ran = self.run_cell("(require ffi/unsafe)\n"
                            "(void ((get-ffi-obj 'puts #f (_fun _string -> _int)) \"from C\"))")
        later = self.kernel.later(0.5)
        self.assertEqual(ran.streams["stdout"] + later.streams["stdout"], "from C\n")

    def test_output_of_a_command(self):
        ran = self.run_cell('(require racket/system) (void (system "echo sub"))')
        self.assertEqual(ran.streams["stdout"], "sub\n")


class Reading(KernelTest):
    def test_a_line(self):
        self.assertEqual(self.run_cell("(read-line)", lines=["typed"]).data(PLAIN), ['"typed"'])

    def test_a_front_end_without_lines(self):
        ran = self.run_cell("(read-line)")
        self.assertIn("no lines to read", ran.streams["stderr"])
        self.works()

    def test_interrupt_while_it_asks(self):
        ran = self.run_cell("(read-line)", lines=[], interrupt_after=[0.5])
        self.assertEqual(ran.error, "interrupted")
        self.works()


class Interrupts(KernelTest):
    def test_what_can_be_broken(self):
        for code in ["(let loop () (loop))",
                     "(let loop ([x 0.5]) (loop (* 4.0 x (- 1.0 x))))",
                     "(sleep 1000)",
                     "(evolve-trajectory (lambda (s) (up 1 (ref s 2) (- (ref s 1)))) (up 0 1 0) 1e9)",
                     "(expt 7 (expt 10 9))",
                     "(require mechanics/plot)\n(define f (frame 0 1 0 1))\n"
                     "(plot-function f (lambda (x) (let loop () (loop))) 0 1 0.1)\nf"]:
            with self.subTest(code):
                ran = self.run_cell(code, interrupt_after=[0.7])
                self.assertEqual(ran.error, "interrupted")
                self.assertLess(ran.seconds, 3)
                self.works()

    def test_stale_interrupt(self):
        self.kernel.manager.interrupt_kernel()
        time.sleep(0.3)
        ran = self.run_cell("(begin (sleep 0.5) 1)")
        self.assertIsNone(ran.error)

    def test_foreign_call(self):
        self.run_cell("(require ffi/unsafe) (define kept 1)")
        ran = self.run_cell("((get-ffi-obj 'sleep #f (_fun _int -> _int)) 60)",
                            interrupt_after=[0.5, 4.5])
        self.assertIn("does not stop yet", ran.streams["stderr"])
        self.assertIn("was ended", ran.error)
        self.assertLess(ran.seconds, 30)
        self.works()
        self.assertIn("undefined", self.run_cell("kept").error)

    def test_subprocess_left_behind(self):
        ran = self.run_cell('(require racket/system) (define p (process "sleep 1234"))\n'
                            "(let loop () (loop))", interrupt_after=[1.0])
        self.assertEqual(ran.error, "interrupted")
        time.sleep(0.5)
        self.assertFalse([p for p in psutil.process_iter(["cmdline"])
                          if (p.info["cmdline"] or [])[-2:] == ["sleep", "1234"]])


class Ends(KernelTest):
    def test_child_killed(self):
        ran = self.run_cell("((get-ffi-obj 'kill #f (_fun _int _int -> _int)) "
                            "((get-ffi-obj 'getpid #f (_fun -> _int))) 9)")
        self.assertIn("undefined", ran.error)
        self.run_cell("(require ffi/unsafe)")
        ran = self.run_cell("((get-ffi-obj 'kill #f (_fun _int _int -> _int)) "
                            "((get-ffi-obj 'getpid #f (_fun -> _int))) 9)")
        self.assertIn("ended by signal 9", ran.error)
        self.assertIn("without the definitions", ran.error)
        self.works()

    def test_child_killed_between_cells(self):
        self.child().kill()
        self.assertIn("ended by signal 9", self.kernel.later(2).streams["stderr"])
        self.works()

    def test_memory(self):
        ran = self.run_cell("(define kept (let loop ([l '()]) (loop (cons (make-vector 100000) l))))")
        self.assertRegex(ran.error, "memory")
        self.works()

    def test_restart(self):
        self.run_cell("(define kept 1)")
        self.kernel.manager.restart_kernel(now=False)
        self.kernel.client.wait_for_ready(timeout=60)
        self.assertIn("undefined", self.run_cell("kept").error)

    def test_wrapper_killed_with_a_busy_child(self):
        kernel = Kernel()
        kernel.send("(let loop () (loop))")
        time.sleep(1.5)
        wrapper = psutil.Process(kernel.manager.provisioner.pid)
        child = wrapper.children()[0]
        os.kill(wrapper.pid, signal.SIGKILL)
        _, alive = psutil.wait_procs([child], timeout=10)
        kernel.client.stop_channels()
        self.assertEqual(alive, [])


class Subshells(KernelTest):
    def subshell(self):
        client = self.kernel.client
        request = client.session.msg("create_subshell_request", {})
        client.control_channel.send(request)
        while True:
            reply = client.get_control_msg(timeout=60)
            if reply["parent_header"].get("msg_id") == request["header"]["msg_id"]:
                return reply["content"]["subshell_id"]

    def test_cells_of_two_shells_take_turns(self):
        client = self.kernel.client
        here = self.kernel.send('(begin (sleep 0.7) (display "here"))')
        content = {"code": '(display "there")', "silent": False, "allow_stdin": False}
        there = client.session.msg("execute_request", content)
        there["header"]["subshell_id"] = self.subshell()
        client.shell_channel.send(there)
        self.assertEqual(self.kernel.follow(here).streams["stdout"], "here")
        ran = self.kernel.follow(there["header"]["msg_id"])
        self.assertEqual((ran.reply["status"], ran.streams["stdout"]), ("ok", "there"))


class Whole(KernelTest):
    def test_no_debugger_is_offered(self):
        client = self.kernel.client
        features = self.kernel.reply_to(client.kernel_info())["supported_features"]
        self.assertEqual(features, ["kernel subshells"])
