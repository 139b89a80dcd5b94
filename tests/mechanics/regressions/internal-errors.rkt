#lang racket/base
;; Questions that ended in a message about the inside: the numerator of a complex number,
;; functions that require keywords, modes of an equation that leaves several shapes free.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(test-case "numerator and denominator of complex numbers"
  (check-equal? (list (numerator (sqrt -1)) (denominator (sqrt -1))) '(+i 1))
  (check-equal? (list (numerator 1/2+1/3i) (denominator 1/2+1/3i)) '(3+2i 6))
  (check-equal? (list (numerator 3/4) (denominator 3/4)) '(3 4)))

(test-case "a function that requires keywords is refused, and it is said what to do"
  (define (f x #:scale scale #:offset c) (+ (* scale x) c))
  (define text
    (string-append
     "prove-zero: expected a function of arguments without keywords\n"
     "  given: f, which requires #:offset and #:scale\n"
     "  give it values for them, as in (lambda (x) (f x #:offset offset #:scale scale))"))
  (check-message text (prove-zero f))
  (check-message text (prove-zero (up 0 f)))
  (check-message text (verify-equal f sin)))

(test-case "keywords that have values of their own are no matter"
  (check-true (proved? (prove-zero (lambda (x #:scale [k 2]) (- (* k x) x x))))))

;; B (x ẏ − y ẋ) added to free particles and oscillators
(define ((L-magnetic B springs) s)
  (define-values (x y vx vy)
    (values (ref (coordinate s) 0) (ref (coordinate s) 1)
            (ref (velocity s) 0) (ref (velocity s) 1)))
  (- (+ (* 1/2 (square (velocity s))) (* B (- (* x vy) (* y vx))))
     (for/fold ([V 0]) ([k springs] [i (in-naturals)])
       (+ V (* 1/2 k (square (ref (coordinate s) i)))))))

(define (frequencies B . springs)
  (define origin (apply up (for/list ([k springs]) 0)))
  (for/list ([mode (normal-modes (L-magnetic B springs) origin)]) (ref mode 0)))
(define (shapes B . springs)
  (define origin (apply up (for/list ([k springs]) 0)))
  (for/list ([mode (normal-modes (L-magnetic B springs) origin)]) (ref mode 1)))

(define (check-frequencies found . expected)
  (for ([w found] [v expected]) (check-= w v 1e-9)))

(test-case "a magnetic term in numbers"
  (check-frequencies (frequencies 1.0 0 0) 0 2)
  (check-frequencies (frequencies 1 0 0 4) 0 2 2)
  (check-frequencies (frequencies 1.0 3 3) 1 3)
  (check-frequencies (frequencies 1 3 3 4) 1 2 3))

(test-case "modes of one frequency have shapes of their own"
  (check-equal? (shapes 0.0 1 1) (list (up 1 0) (up 0 1)))
  (define twice (shapes 1 0 0 4))
  (check-equal? (length twice) 3)
  (for ([v twice] #:when #t [w twice] #:unless (eq? v w)) (check-false (equal? v w))))

(test-case "three coordinates in symbols, joined by a magnetic term"
  (check-message
   (string-append "normal-modes: 3 coordinates act on one another, and formulas are for 1 and 2\n"
                  "  give the parameters numbers for numbers in return")
   (normal-modes (lambda (s)
                   (+ ((L-magnetic 'B '(k k k)) s)
                      (* 'c (ref (coordinate s) 0) (ref (coordinate s) 2))))
                 (up 0 0 0))))
