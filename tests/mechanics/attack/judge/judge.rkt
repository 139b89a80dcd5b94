#lang racket/base
;; Is a claim right?  Judged at points, by intervals.
;;
;; A statement is `left = right` where the relations `given` hold.  The judge asks of a
;; proof that it has points, at which all it assumes holds and both sides have values,
;; and that these do not differ at any; of a refutation that both sides have values at its
;; witness, which differ.  Flonums look first; what they find is confirmed, and what they
;; cannot see is sought, with many digits.

(require "boxes.rkt" "evaluate.rkt" "fixed.rkt" "flonum.rkt" "interval.rkt" "point.rkt"
         "relation.rkt" "witness.rkt")

(provide (struct-out fault) judge-proof judge-refutation judge-simplified both-nonzero?)

;; kind : a symbol that says what is wrong; numbers : symbol -> rational, or #f
;; left, right : values there, or #f
(struct fault (kind numbers left right) #:prefab)

(define sharp (fixed-intervals 224))

;; Points that are enough, and how many are tried.
(define enough 6)
(define tries 60)
(define more-tries 400)

;; ---------------------------------------------------------------------------
;; Points of a question

;; The points tried, by what was found there.
;; used : (numbers ...) at which left has a value, and given and assumed hold
;; in-domain : how many there were at which left has a value and given holds
(struct survey (used in-domain))

(define (reading left right slack)
  (if (decimals? (list left right)) (loose-decimal slack) exact-decimal))

(define (decimals? e)
  (cond [(flonum? e) #t]
        [(pair? e) (or (decimals? (car e)) (decimals? (cdr e)))]
        [else #f]))

;; visit : numbers, point -> does it end the search?
;; hints : hashes of numbers to try first
(define (find-points sides given assumed hints decimal visit)
  (define symbols (apply symbols-of (append sides (relation-sides (append given assumed)))))
  (let loop ([k (- (length hints))] [used '()] [in-domain 0])
    (define limit (if (null? used) more-tries tries))
    (cond
      [(or (= k limit) (= (length used) enough)) (survey used in-domain)]
      [else
       (define numbers
         (if (negative? k)
             (completed (list-ref hints (+ k (length hints))) symbols)
             (random-numbers symbols k)))
       (define where (make-point numbers (modulo k 5) decimal))
       (cond [(not (in-question? sides given where)) (loop (+ k 1) used in-domain)]
             [(not (all-hold? assumed where flonum-intervals)) (loop (+ k 1) used (+ in-domain 1))]
             [(visit numbers where) (survey (cons numbers used) (+ in-domain 1))]
             [else (loop (+ k 1) (cons numbers used) (+ in-domain 1))])])))

;; k : even where numbers may be negative
(define (completed hint symbols [k 1])
  (for/fold ([all (random-numbers symbols k)]) ([(s x) (in-hash hint)]) (hash-set all s x)))

(define (in-question? sides given where)
  (and (for/and ([e (in-list sides)]) (value? (value-at e where flonum-intervals)))
       (all-hold? given where flonum-intervals)))

;; ---------------------------------------------------------------------------
;; Proofs

;; -> #f, 'unjudged or a fault
(define (judge-proof left right given assumed hints)
  (define decimal (reading left right (expt 2 -50)))
  (define found #f)
  (define s
    (find-points (list left right) given assumed hints decimal
                 (lambda (numbers where)
                   (set! found (or found (difference-at left right numbers where)))
                   found)))
  (or found (judge-survey s (list left right) given assumed)))

;; A difference flonums see, confirmed; or one of many digits, at every third point.
(define (difference-at left right numbers where)
  (define (values-differ? A)
    (define u (value-at left where A))
    (define v (value-at right where A))
    (and (value? u) (value? v) (differ? u v A)
         (fault 'values-differ numbers (value->exact u A) (value->exact v A))))
  (and (or (zero? (random 3)) (values-differ? flonum-intervals))
       (values-differ? sharp)))

;; Were there points?
(define (judge-survey s sides given assumed)
  (cond [(pair? (survey-used s)) #f]
        [(> (survey-in-domain s) 0)
         (if (or (> (survey-in-domain s) 15) (empty? sides (append given assumed)))
             (fault 'assumptions-hold-nowhere #f #f #f)
             'unjudged)]
        [(empty? sides given) (fault 'nowhere-defined #f #f #f)]
        [else 'unjudged]))

;; ---------------------------------------------------------------------------
;; Values of simplified expressions

(define (judge-simplified e simple given assumed hints)
  (define decimal (reading e simple (expt 2 -40)))
  (define found #f)
  (define defined 0)
  (define s
    (find-points (list e) given assumed hints decimal
                 (lambda (numbers where)
                   (when (value? (value-at simple where flonum-intervals))
                     (set! defined (+ defined 1)))
                   (set! found (or found (difference-at e simple numbers where)))
                   found)))
  (or found
      (judge-form-survey s (list e) given assumed)
      (and (eqv? defined 0)
           (if (ormap (lambda (numbers) (surely-undefined? simple numbers)) (survey-used s))
               (fault 'result-nowhere-defined (car (survey-used s)) #f #f)
               'unjudged))))

;; Of what is nowhere defined every form is right.
(define (judge-form-survey s sides given assumed)
  (if (eqv? 0 (survey-in-domain s)) 'unjudged (judge-survey s sides given assumed)))

(define (surely-undefined? e numbers)
  (no-value? (value-at e (make-point numbers 0) sharp)))

;; ---------------------------------------------------------------------------
;; Refutations

;; witness : ((S-expression . number) ...); symbols it does not name may be anything that is
;; in the question
(define (judge-refutation left right given hints witness)
  (define symbols (apply symbols-of left right (relation-sides given)))
  (define numbers (witness-numbers witness))
  (define unnamed (remq* (hash-keys numbers) symbols))
  (define (random-completion hint k)
    (for/fold ([all numbers]) ([(s x) (in-hash (completed hint unnamed k))]
                               #:unless (hash-has-key? numbers s))
      (hash-set all s x)))
  (let loop ([k 0] [worst #f])
    (define all (random-completion (if (< k (length hints)) (list-ref hints k) (hash)) (* 2 k)))
    (define found (judge-witness left right given all witness))
    (define so-far (if (eq? worst 'unjudged) worst found))
    (if (or (not found) (null? unnamed) (= k 90)) (and found so-far) (loop (+ k 1) so-far))))

(define (judge-witness left right given numbers witness)
  (let loop ([bits '(96 224 900 2400)])
    (define A (fixed-intervals (car bits)))
    (define where (witness-point numbers witness exact-decimal))
    (define u (value-at left where A))
    (define v (value-at right where A))
    (define (wrong kind) (fault kind numbers (shown u A) (shown v A)))
    (cond [(or (no-value? u) (no-value? v)) (wrong 'no-value-at-witness)]
          [(and (value? u) (value? v) (differ? u v A))
           (if (broken? given where A) (wrong 'witness-outside-given) #f)]
          [(and (real? u) (real? v)) (wrong 'no-difference-at-witness)]
          [(pair? (cdr bits)) (loop (cdr bits))]
          [(or (two-values? u) (two-values? v)) (wrong 'function-of-two-values)]
          [(and (value? u) (value? v)) (wrong 'no-difference-at-witness)]
          [else 'unjudged])))

(define (shown v A) (and (value? v) (value->exact v A)))

;; ---------------------------------------------------------------------------

;; Is there a point of the question at which e is certainly not zero?
(define (both-nonzero? left right given hints)
  (define found #f)
  (find-points (list left right) given '() hints exact-decimal
               (lambda (numbers where)
                 (define v (value-at right where flonum-intervals))
                 (set! found (and (memv (sign-of v) '(1 -1)) numbers))
                 found))
  found)
