#lang racket/base
;; Names of the user's variables in other languages.
;;
;; Greek letters are spelled out, a sign that no identifier may hold becomes an underscore; a
;; word of the language, the name of another variable, or one of the names v7, v12 ... that
;; values have, gets another one behind it.

(require racket/string
         "../../algebra/notation/name.rkt")

(provide identifiers identifier? C-keywords python-keywords)

;; names : symbols; reserved : strings -> as many strings, all different
(define (identifiers names reserved)
  (for/fold ([done '()] #:result (reverse done)) ([name (in-list names)])
    (cons (free-identifier (identifier name) (append done reserved)) done)))

(define (free-identifier text taken)
  (if (or (member text taken) (regexp-match? #px"^v[0-9]+$" text))
      (free-identifier (string-append text "_") taken)
      text))

(define (identifier name)
  (define plain (regexp-replace* #px"[^A-Za-z0-9_]" (spelled (symbol->string name)) "_"))
  (if (regexp-match? #px"^[A-Za-z]" plain) plain (string-append "x" plain)))

(define (spelled text)
  (string-append*
   (for/list ([c (in-string text)])
     (define letter (string c))
     (if (memv c '(#\′ #\')) "prime" (or (letter->greek letter) letter)))))

;; Is the text good for the name of a folder and of functions?
(define (identifier? text)
  (and (regexp-match? #px"^[A-Za-z][A-Za-z0-9_]*$" text) (not (member text (words)))))

;; Words of C and of Python, and names that exported folders have already.
(define (words) (append C-keywords python-keywords '("main" "dop853" "numpy" "jax" "ctypes" "os")))

(define C-keywords
  (string-split
   (string-append
    "auto break case char const continue default do double else enum extern float for goto if "
    "inline int long register restrict return short signed sizeof static struct switch typedef "
    "union unsigned void volatile while")))

(define python-keywords
  (string-split
   (string-append
    "False None True and as assert async await break class continue def del elif else except "
    "finally for from global if import in is lambda nonlocal not or pass raise return try while "
    "with yield")))
