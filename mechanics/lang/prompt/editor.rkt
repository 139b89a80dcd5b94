#lang racket/base
;; Lines edited with libedit, through Racket's readline library.  To require this module
;; fails where libedit is not installed; so it is loaded on demand.

(require ffi/unsafe
         readline/readline)

(provide edit-line recall! complete-with!)

;; prompt : string -> a line as a string, or eof.  A break leaves the terminal as it was.
(define (edit-line prompt)
  (define line (readline-bytes (string->bytes/utf-8 prompt)))
  (if (bytes? line) (bytes->string/utf-8 line #\?) line))

;; An entry to go back to with the arrow keys.
(define (recall! text) (add-history-bytes (string->bytes/utf-8 text)))

;; names-for : the beginning of a name -> list of names
(define (complete-with! names-for)
  (read-names-as-racket-does!)
  (set-completion-function! names-for))

;; ---------------------------------------------------------------------------
;; Completion of Racket's names.  By default libedit splits F->C at the arrow, and completes F- as
;; the shell would, F-\>C: unless the program's own completion comes first, which here finds
;; nothing.

(define (read-names-as-racket-does!)
  (set-variable! "rl_basic_word_break_characters" _pointer (immobile #" \t\n\"'`,;()[]{}"))
  (set-variable! "rl_attempted_completion_function" _pointer nothing-found))

(define nothing-found
  (cast (lambda (text start end) #f)
        (_fun #:keep #t #:async-apply (lambda (call) (call)) _pointer _int _int -> _pointer)
        _pointer))

(define (set-variable! name type value)
  (define library (ffi-lib "libedit" '("3" "2" "0" "") #:fail (lambda () #f)))
  (when (and library (ffi-obj-ref name library (lambda () #f)))
    (set-ffi-obj! name library type value)))

;; For the library to keep: neither moved nor reclaimed.
(define (immobile bytes)
  (define n (bytes-length bytes))
  (define memory (malloc (add1 n) 'raw))
  (memcpy memory bytes n)
  (ptr-set! memory _byte n 0)
  memory)
