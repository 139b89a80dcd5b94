#lang racket/base
;; Definitions that hardly mean what they say: told where they are expanded, once, and in a
;; module with the line.

(require racket/file
         racket/string
         "../../support/checks.rkt" "../../support/run-text.rkt")

;; The notes on the error port while this is declared.
(define (told . text)
  (define port (open-output-string))
  (parameterize ([current-error-port port])
    (declare (apply lines language text)))
  (string-split (get-output-string port) "\n"))

(test-case "a quoted argument within arithmetic is a symbol"
  (check-equal?
   (told "(define ((L m) (up t q v)) (- (* 1/2 m (square 'v)) (* 'k (square q))))")
   '("; L: 'v is a symbol, a constant here; the v of (up t q v) is written v without a quote"))
  (check-equal?
   (told "(define (path t) (* 'a (cos (* 'omega 't))))")
   '("; path: 't is a symbol, a constant here; the argument is written t without a quote"))
  (check-equal? (length (told "(define ((f m) x #:k [k 1] . more) (+ (* 'm 'k) (sqrt 'more)))")) 3)
  (check-equal? (length (told "(define f (lambda ((up t (up x y))) (* 2 'y)))")) 1))

(test-case "elsewhere a symbol may be meant"
  (check-equal? (told "(define (f x) (substitute x 'x 3))"
                      "(define (g q) (list 'q q '(* 2 q)))"
                      "(define (h t) (* 'a `(* ,t t)))"
                      "(define m 3)"
                      "(define (k v) (* 'm v))")
                '()))

(test-case "an expression before the last one is without effect"
  (check-equal?
   (told "(define ((L m k) (up t q v))" "  (* 1/2 m (square v))" "  (* -1/2 k (square q)))")
   (list (string-append "; L: the value of (* 1/2 m (square v)) is not used; "
                        "that of the last expression is the value")))
  (check-equal? (length (told "(define (f x) x 3 (up x x) (* 2 x))")) 3)
  (check-equal? (told "(define (f x) \"doubles\" (define y 2) (displayln x) (* y x))") '()))

(test-case "a local tuple begins with the time, and coordinates come before velocities"
  (check-equal?
   (told "(define (L (up th thd t)) (square thd))")
   '("; L: (up th thd t): a local tuple begins with the time, and t stands behind"))
  (check-equal?
   (told "(define (L (up q t v)) v)")
   '("; L: (up q t v): a local tuple begins with the time, and t stands second"))
  (for ([pattern '("(up t thd th)" "(up t v q)" "(up t xdot x)" "(up t vx x)" "(up t qdot q)")])
    (check-equal? (told (format "(define (L ~a) t)" pattern))
                  (list (format "; L: ~a: coordinates come before velocities in a local tuple"
                                pattern))))
  (check-equal? (told "(define (f (up x y) (up a b c) (up t (up x1 y1) (up vx vy))) x)"
                      "(define (g (up t q v)) v)"
                      "(define (h (up t theta omega)) t)"
                      "(define (k (up x t)) x)")
                '()))

(test-case "a pattern outside of the head is refused"
  (check-regexp-match
   #rx"define: a pattern stands among the arguments: [(]define [(][(]L m[)] [(]up t q v[)][)] ...[)]"
   (refusal "(define (L m) (up t q v) (* m v))"))
  (check-regexp-match
   #rx"among the arguments: [(]define [(]L [(]up t [(]up x y[)] _[)][)] ...[)]"
   (refusal "(define L (up t (up x y) _) (* x y))"))
  (check-equal? (told "(define x 1)" "(define v (up x x))" "(define (f y) (up x y))") '()))

(test-case "a line is told of a file, and a note once"
  (define file (make-temporary-file "slips-~a.rkt"))
  (dynamic-wind
   void
   (lambda ()
     (display-to-file (lines language "" "(define (path t)" "  (+ (sin 't) (cos 't)))")
                      file #:exists 'truncate)
     (define port (open-output-string))
     (parameterize ([current-error-port port] [current-namespace (namespace)])
       (dynamic-require file #f))
     (check-regexp-match #rx"^; path, line 4: 't is a symbol" (get-output-string port))
     (check-equal? (length (regexp-match* #rx"\n" (get-output-string port))) 1))
   (lambda () (delete-file file))))

(test-case "at the prompt, too, beside the answers"
  (define-values (output errors)
    (session '("-I" "mechanics") "(define (f t) (* 2 't))" "(f 3)"))
  (check-equal? output '("(* 2 t)"))
  (check-regexp-match #rx"^; f: 't is a symbol" errors))
