#lang racket/base
;; Starts a session of mechanics.  Required by `configure-runtime` submodules only, never by a
;; library.

(require "session-start.rkt")

(start-session!)
