#lang mechanics
;; Checks of rackunit that ask for verdicts: they hold where they should, and fail with the
;; evidence where not.

(require mechanics/book
         mechanics/rackunit
         (except-in rackunit check))

(define L (L-harmonic 'm 'k))
(define (motion t) (* 'a (cos (* (sqrt (/ 'k 'm)) t))))
(define (other t) (* 'a (cos (* 'w t))))
(define (exchange (up t q p)) (up t p (- q)))

(test-case "checks hold where their verdicts do"
  (check-solution L motion)
  (check-not-solution L other)
  (check-residual (- (square (sin 'x)) (- 1 (square (cos 'x)))))
  (check-equal-expression (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x)))
  (check-conserved L (Lagrangian->energy L) (up 't 'x 'v))
  (check-canonical exchange (up 't 'q 'p))
  (check-proved (verify-ignorable (L-free-particle 'm) 'x (up 't (up 'x 'y) (up 'vx 'vy))))
  (check-refuted (prove-zero (- 'x 'y))))

;; The failure of a check: its message, and the text of what is told beside.
(define-syntax-rule (failure-of check)
  (with-handlers ([exn:test:check?
                   (lambda (e)
                     (for/list ([i (exn:test:check-stack e)])
                       (list (check-info-name i) (format "~a" (check-info-value i)))))])
    (parameterize ([current-check-handler raise]) check)
    'held))

(define (told failure name) (let ([found (assq name failure)]) (and found (cadr found))))

(test-case "a failure shows residual, condition, witness, and the message given"
  (define found (failure-of (check-solution L other "the frequency")))
  (check-equal? (told found 'name) "check-solution")
  (check-equal? (told found 'expected) "proved")
  (check-equal? (told found 'message) "the frequency")
  (check-regexp-match #rx"zero if: k = " (told found 'verdict))
  (check-regexp-match #rx"\n +at: " (told found 'verdict)))

(test-case "each check can fail"
  (check-not-equal? 'held (failure-of (check-not-solution L motion)))
  (check-not-equal? 'held (failure-of (check-residual 'x)))
  (check-not-equal? 'held (failure-of (check-equal-expression 'x 'y)))
  (check-not-equal? 'held (failure-of (check-conserved L velocity (up 't 'x 'v))))
  (check-not-equal? 'held (failure-of (check-canonical (lambda ((up t q p)) (up t p q))
                                                       (up 't 'q 'p))))
  (check-not-equal? 'held (failure-of (check-proved (prove-zero 'x))))
  (check-not-equal? 'held (failure-of (check-refuted (prove-zero 0)))))

(test-case "an undecided verdict holds for no check"
  (define undecided (prove-zero (- (exact->inexact 1/3) 1/3)))
  (check-not-equal? 'held (failure-of (check-proved undecided)))
  (check-not-equal? 'held (failure-of (check-refuted undecided))))

(test-case "what is no verdict is no proof"
  (check-not-equal? 'held (failure-of (check-proved #t))))

(test-case "maps asked about wrongly are complained of"
  (check-exn #rx"its values are to be states"
             (lambda () (check-canonical (lambda ((up t q p)) q) (up 't 'q 'p))))
  (check-exn #rx"made of symbols" (lambda () (check-canonical exchange (up 't 1 'p)))))
