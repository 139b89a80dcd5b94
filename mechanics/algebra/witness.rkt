#lang racket/base
;; Points at which an expression is not zero.
;;
;; A witness is for a person to check, so the first points tried give small
;; integers to everything and 0 to what stands under a sine, an exponential or
;; the like, where the value is then exact.  If the expression vanishes there,
;; points with integers for all leaves follow, where its value is known to
;; within rounding; zeros at those are what "undecided" reports.  The points
;; are always the same.

(require "operation.rkt" "expression.rkt" "approximate.rkt" "evaluate.rkt")

(provide find-witness)

;; How many points with integers for all leaves are tried.
(define point-limit 12)

;; e : the expression; residual : a simpler one of the same value, in whose
;; leaves the point is given.  The value is that of e itself, so simplification
;; is no part of the evidence; where the residual has another value, the point
;; is outside what simplification took for granted, and is passed over.
;; Where simplification took signs for granted, `positive?`, all integers are.
;; -> witness value bound points; witness is #f if none was found.
(define (find-witness e residual positive?)
  (define-values (point value) (exact-witness e residual))
  (if point
      (values point value 0 0)
      (search e residual positive?)))

;; ---------------------------------------------------------------------------
;; Points where transcendental functions have exact values

(define (exact-witness e residual)
  (define under (leaves-under-functions residual))
  (define outside (leaves-outside-functions residual))
  (define only-under
    (for/hash ([leaf (in-hash-keys under)] #:unless (hash-ref outside leaf #f)) (values leaf #t)))
  (let loop ([tries (list (cons only-under 0) (cons only-under 1) (cons under 0))])
    (cond [(null? tries) (values #f 0)]
          [else
           (define point (integer-point residual (cdar tries) (caar tries)))
           (define-values (value error) (value-of-both e residual point 0))
           (if (and (exact? value) (not (eqv? value 0)) (eqv? error 0))
               (values point value)
               (loop (cdr tries)))])))

(define algebraic (list op:+ op:- op:* op:/ op:expt op:sqrt op:abs))

;; The leaves standing somewhere below a function such as sin.
(define (leaves-under-functions e)
  (define found (make-hash))
  (node-fold/down e
                  (lambda (n below?) (or below? (transcendental? n)))
                  (lambda (leaf below?) (when below? (hash-set! found leaf #t))))
  found)

;; The leaves standing somewhere that no such function is above.
(define (leaves-outside-functions e)
  (define found (make-hash))
  (node-fold/down e
                  (lambda (n below?) (or below? (transcendental? n)))
                  (lambda (leaf below?) (unless below? (hash-set! found leaf #t))))
  found)

(define (transcendental? n)
  (and (operation? (node-head n)) (not (memq (node-head n) algebraic))))

;; Visits the leaves of e, literal applications among them, with a state passed
;; down from the root; every node once for each state.
(define (node-fold/down e step visit)
  (define seen (make-hasheq))
  (let walk ([e e] [state #f])
    (cond [(number? e) (void)]
          [(or (symbol? e) (literal-head? (node-head e))) (visit e state)]
          [(memv state (hash-ref seen e '())) (void)]
          [else
           (hash-update! seen e (lambda (states) (cons state states)) '())
           (define next (step e state))
           (for ([a (in-list (node-args e))]) (walk a next))])))

;; ---------------------------------------------------------------------------
;; Points with integers for all leaves

(define (search e residual positive?)
  (let loop ([k 0] [bound 0] [points 0])
    (cond
      [(= k point-limit) (values #f 0 bound points)]
      [else
       (define point (integer-point residual (if positive? k (- k))))
       (define-values (value error) (value-of-both e residual point k))
       (cond [(not (decent? value error)) (loop (+ k 1) bound points)]
             [(> (magnitude value) (* 4 error)) (values point value error points)]
             [else (loop (+ k 1) (max bound error) (+ points 1))])])))

(define (decent? value error)
  (and (rational? (magnitude value)) (rational? error)))

;; ---------------------------------------------------------------------------

;; The value and error of e, not numbers if those of the residual differ.
(define (value-of-both e residual point k)
  (define-values (value error) (value-at e point k))
  (define-values (other its-error) (value-at residual point k))
  (if (or (eq? e residual)
          (and (decent? value error) (decent? other its-error)
               (<= (magnitude (- value other)) (* 4 (+ error its-error)))))
      (values value error)
      (values +nan.0 +nan.0)))

;; The value and error of e where the point says; not a number where e is not
;; defined.  Leaves of e that the residual has lost get integers of their own,
;; each the same one wherever it stands.
(define (value-at e point k)
  (with-handlers ([exn:fail? (lambda (x) (values +nan.0 +nan.0))])
    (approximate-expression e (point-lookup point (remembering (integers-from (+ 100 k)))))))

(define (remembering next)
  (define seen (make-hash))
  (lambda (leaf arguments)
    (hash-ref! seen (leaf-key leaf arguments) (lambda () (next leaf arguments)))))

;; Small integers for the leaves of e, zeros for those of `zeros`: ((leaf .
;; integer) ...).  A literal function has one value for one argument.
(define (integer-point e k [zeros #hash()])
  (define next (integers-from k))
  (define seen (make-hash))
  (define point '())
  (define (lookup leaf arguments)
    (define value
      (hash-ref! seen (leaf-key leaf arguments)
                 (lambda () (if (hash-ref zeros leaf #f) 0 (next leaf arguments)))))
    (unless (assoc leaf point)
      (set! point (cons (cons leaf value) point)))
    value)
  (with-handlers ([exn:fail? void])
    (evaluate-expression e lookup))
  (reverse point))

;; A literal function is known by its name, derivative and arguments' values.
(define (leaf-key leaf arguments)
  (if (symbol? leaf)
      leaf
      (let ([head (node-head leaf)])
        (list (literal-head-name head) (literal-head-index head) arguments))))

;; The k-th source of small integers, by a linear congruence: positive ones for
;; k not negative, of either sign for k negative.
(define (integers-from k)
  (define n (abs k))
  (define state (+ 12345 (* 7919 n)))
  (define range (cond [(< n 2) 3] [(< n 6) 5] [else 11]))
  (lambda (leaf arguments)
    (set! state (modulo (+ (* 1103515245 state) 12345) 2147483648))
    (define size (+ 1 (modulo (quotient state 65536) range)))
    (if (and (negative? k) (odd? (quotient state 1048576))) (- size) size)))
