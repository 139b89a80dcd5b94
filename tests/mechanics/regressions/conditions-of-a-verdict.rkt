#lang racket/base
;; Of two conditions the second was broken as if it stood where the first ended, and
;; then put elsewhere: its lines did not begin below each other.

(require racket/string
         mechanics
         mechanics/show/display/result-lines
         (only-in mechanics/book L-harmonic)
         "../support/checks.rkt")

(define (proposed t) (* (exp (* -1 'gamma t)) (cos (* 'omega t))))
(define verdict
  (verify-solution (L-harmonic 'm 'k) proposed
                   #:force (lambda (local) (* -1 'b (velocity local)))))

(define (has-lines? text . lines)
  (string-contains? text (apply string-append (map (lambda (l) (string-append "\n" l)) lines))))

(define (check-printed columns . lines)
  (define text (value->lines verdict columns))
  (check-true (apply has-lines? text lines) text))

(test-case "a condition that does not fit begins a line, and is not parted from its name"
  (check-printed 76
                 "  zero if: b = (* 2 gamma m),"
                 "           k = (+ (* b gamma) (* -1 (expt gamma 2) m) (* m (expt omega 2)))"
                 "  at: "))

(test-case "one that fits on no line is broken where it stands"
  (check-printed 50
                 "  zero if: b = (* 2 gamma m),"
                 "           k = (+ (* b gamma)"
                 "                  (* -1 (expt gamma 2) m)"
                 "                  (* m (expt omega 2)))"
                 "  at: "))

(test-case "a witness is broken between its equations"
  (define lines (string-split (value->lines verdict 30) "\n"))
  (for ([l lines]) (check-false (regexp-match? #rx"=$" l) l)))
