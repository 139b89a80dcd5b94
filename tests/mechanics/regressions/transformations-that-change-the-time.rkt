#lang racket/base
;; A transformation to twice the time was proved canonical, for brackets do not see that; and of
;; one that mixes the time with coordinates it was said that H∘C is its Hamiltonian.

(require mechanics "../support/checks.rkt")

(define line (up 't 'q 'p))
(define ((changing f) s) (up (f s) (coordinate s) (momentum s)))
(define (verdict-on f) (verify-canonical (changing f) line))

(test-case "another pace, and a time that depends on the state"
  (for ([f (list (lambda (s) (* 2 (time s))) (lambda (s) (square (time s))) (lambda (s) 0)
                 (lambda (s) (+ (time s) (coordinate s))) momentum)])
    (define v (verdict-on f))
    (check-equal? (verdict-status v) 'refuted)
    (check-equal? (verdict-remarks v)
                  '("the transformation changes the time, which is to go on as in the new state"))))

;; what motions say: those of H' do not go to those of H
(test-case "and so with a Hamiltonian"
  (define (H s) (/ (square (momentum s)) 2))
  (check-equal? (verdict-status
                 (verify-canonical (changing (lambda (s) (* 2 (time s)))) H H line))
                'refuted))

(test-case "another origin of time is none"
  (check-equal? (verdict-status (verdict-on time)) 'proved)
  (check-equal? (verdict-status (verdict-on (lambda (s) (+ 'a (time s))))) 'proved)
  (check-equal? (verdict-status (verify-canonical (shift-t 'delta) line)) 'proved))

(test-case "a factor of all brackets is still told"
  (check-regexp-match #rx"multiplied by 2"
                      (car (verdict-remarks
                            (verify-canonical (lambda (s) (up (time s) (* 2 (coordinate s))
                                                              (momentum s)))
                                              line)))))
