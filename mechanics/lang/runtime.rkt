#lang racket/base
;; Starts a session of mechanics.  Required by `configure-runtime` submodules only, never by a
;; library.

(require "session-start.rkt"
         (only-in "../show/display/program-end.rkt" start-program!))

(start-session!)
(start-program!)
