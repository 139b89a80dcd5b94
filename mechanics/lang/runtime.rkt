#lang racket/base
;; What a session of mechanics sets when it starts.  Required by
;; `configure-runtime` submodules only, never by a library.

(require "printer.rkt"
         "unknown-name/unbound.rkt"
         "../error/note.rkt")

(print-as-expression #t)
(install-printer!)
(install-hints!)
(start-session-of-notes!)
