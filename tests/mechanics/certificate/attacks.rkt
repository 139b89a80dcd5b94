#lang racket/base
;; Attacks: false theorems with the proofs that true ones of their kind have.  A total function, an
;; angle on the wrong side of the cut, a root's sign or a lost hypothesis would let them pass; Coq,
;; where it is installed, rejects each.

(require racket/list racket/string
         mechanics/algebra/expression/read
         mechanics/certificate/certificate mechanics/certificate/Coq-check
         mechanics/certificate/identity-theorem
         "../support/checks.rkt" "../support/skip.rkt"
         "../support/certification/kept-judgements.rkt"
         "../support/certification/proved-claims.rkt")

;; ((name . text) ...), of equalities that do not hold
(define false-equalities
  (for/list ([e (in-list
                 '((an-angle-on-the-left (atan y x) (atan (/ y x)))
                   (complementary-angles (+ (atan y x) (atan x y)) (* 1/2 :pi))
                   (sine-for-cosine (sin (atan y x)) (/ x (sqrt (+ (* x x) (* y y)))))
                   (angle-of-a-double-point (atan (* 2 y) (* -2 x)) (atan y x))
                   (root-of-the-other-sign (sqrt (expt (- (sin w) 2) 2)) (- (sin w) 2))
                   (modulus-divided (log (abs (- (* x x) 9)))
                                    (- (log (abs (- x 3))) (log (abs (+ x 3)))))
                   (negative-over-x (sqrt (/ -1 x)) (/ (sqrt (* -1 x)) x))
                   (hyperbolic-sign (+ (/ (expt (cosh x) 2) (expt (sinh x) 2))
                                       (/ 1 (expt (sinh x) 2)))
                                    1)
                   (modulus-left-out (/ x (sqrt (+ (expt (/ x a) 2) (expt (/ y a) 2))))
                                     (/ (* x a) (sqrt (+ (* x x) (* y y)))))))])
    (define-values (left right) (apply values (map datum->expression (cdr e))))
    (cons (car e) (theorem-file (identity-theorem (list (cons left right)) '() '())))))

;; The certificate of a claim with other words in its statements, each of which is there
(define (changed claim . changes)
  (define text
    (certificate-text (certificate-or-reason (asked-verdict (car (proved-claims (list claim)))))))
  (cons claim
        (for/fold ([t text]) ([change (in-list changes)])
          (check-true (string-contains? t (car change)) (format "~a: ~a" claim (car change)))
          (string-replace t (car change) (cadr change)))))

(define changed-texts
  (list
   (changed 'fall-in-decimals '("R := 10 - 49 / 10" "R := 10 - 48 / 10"))
   (changed 'fall-in-decimals '("v - 49 / 5 * q" "v - 98 / 5 * q"))
   (changed 'parameter-called-t '("R := t * cos" "R := time * cos"))
   (changed 'parameter-called-t '("1 / 2 * k * q" "1 / 2 * time * q"))
   ;; at x = 0 there is no tangent, and at a negative k no root
   (changed 'tangent-of-an-angle '(" /\\\n  cos (atan2 y x) <> 0." ".")
            '("(given_1 & given_2)" "given_1"))
   (changed 'root-of-a-power '(" /\\\n  0 <= k * Rpower R_ n." ".")
            '("(given_1 & given_2)" "given_1"))
   ;; another angle: half of it, and one that jumps at the other half line
   (changed 'angle-of-a-point '("then atan (y / x)\n" "then atan (y / x) / 2\n"))
   (changed 'angle-of-a-point '("else PI." "else 0."))))

(test-case "false theorems are rejected, by their proofs"
  (skip-unless (find-Coq) "Coq is not there (Debian: coq, libcoq-coquelicot)"
    (define all (append false-equalities changed-texts))
    (check-false (check-duplicates (map cdr all)))
    (define judged 0)
    (errors-in-sessions
     (map cdr all)
     (lambda (text error _)
       (define name (format "~a" (car (findf (lambda (a) (equal? text (cdr a))) all))))
       (set! judged (+ judged 1))
       (check-true (string? error) name)
       (check-true (rejected-by-proof? (judgement 'rejected 0. (or error ""))) name)))
    (check-equal? judged (length all))))
