#lang racket/base
;; Algebraic laws as data, so that any operations can be run through them: the
;; right ones must break none, and every law must be broken by some wrong ones.

(require rackunit)

(provide (struct-out law) broken check-lawful check-broken
         (struct-out operations) ring-laws field-laws)

;; holds? : operations element element element -> boolean
(struct law (name holds?))

;; invert : element -> element, or #f in a ring
(struct operations (zero one add subtract negate multiply invert equal?))

;; The names of the laws that fail on some of the triples.
(define (broken laws o triples)
  (for/list ([l (in-list laws)]
             #:unless (for/and ([t (in-list triples)])
                        (apply (law-holds? l) o t)))
    (law-name l)))

(define (check-lawful laws o triples)
  (check-equal? (broken laws o triples) '()))

;; The named law fails, and is one of the laws.
(define (check-broken name laws o triples)
  (check-not-false (member name (broken laws o triples))
                   (format "this should break: ~a" name)))

;; ---------------------------------------------------------------------------
;; Rings

(define-syntax-rule (ring-law name (p q r) (zero one + - negate * invert =) holds)
  (law name
       (lambda (o p q r)
         (define zero (operations-zero o))
         (define one (operations-one o))
         (define + (operations-add o))
         (define - (operations-subtract o))
         (define negate (operations-negate o))
         (define * (operations-multiply o))
         (define invert (operations-invert o))
         (define = (operations-equal? o))
         holds)))

(define-syntax-rule (define-laws id names [name variables holds] ...)
  (define id (list (ring-law name variables names holds) ...)))

(define-laws ring-laws (zero one + - negate * invert =)
  ["addition commutes" (p q r) (= (+ p q) (+ q p))]
  ["addition associates" (p q r) (= (+ (+ p q) r) (+ p (+ q r)))]
  ["zero is neutral" (p q r) (and (= (+ p zero) p) (= (+ zero p) p))]
  ["a negative cancels" (p q r) (= (+ p (negate p)) zero)]
  ["subtraction undoes addition" (p q r) (= (- (+ p q) q) p)]
  ["multiplication commutes" (p q r) (= (* p q) (* q p))]
  ["multiplication associates" (p q r) (= (* (* p q) r) (* p (* q r)))]
  ["one is neutral" (p q r) (and (= (* p one) p) (= (* one p) p))]
  ["zero absorbs" (p q r) (and (= (* p zero) zero) (= (* zero p) zero))]
  ["multiplication distributes" (p q r) (= (* p (+ q r)) (+ (* p q) (* p r)))])

(define-laws inversion-laws (zero one + - negate * invert =)
  ["an inverse cancels" (p q r) (or (= p zero) (= (* p (invert p)) one))]
  ["inversion twice is nothing" (p q r) (or (= p zero) (= (invert (invert p)) p))]
  ["inversion multiplies" (p q r)
                          (or (= p zero) (= q zero)
                              (= (invert (* p q)) (* (invert p) (invert q))))])

(define field-laws (append ring-laws inversion-laws))
