#lang racket/base
;; Is a proof right, is a simplified expression?  Judged at points, by intervals.
;;
;; A statement is `left = right` where the relations `given` hold.  The judge asks of a
;; proof that it has points, at which all it assumes holds and both sides have values,
;; and that these do not differ at any.  Flonums look first; what they find is confirmed,
;; and what they cannot see is sought, with many digits.

(require "boxes.rkt" "climb.rkt" "evaluate.rkt" "fault.rkt" "fixed.rkt" "flonum.rkt" "interval.rkt"
         "point.rkt" "relation.rkt")

(provide judge-proof judge-simplified both-nonzero?)

(define sharp (fixed-intervals 224))

;; Points that are enough besides those that are hinted at, and how many are tried.
(define enough 6)
(define tries 60)
(define more-tries 400)

;; From how many points a place is sought where all holds that is assumed: what one climb meets
;; another does not.
(define climbs 40)

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
  (define all (append sides (relation-sides (append given assumed))))
  (define symbols (apply symbols-of all))
  (define constants (apply constants-of all))
  (define (point-of numbers) (make-point numbers 0 decimal))
  (let loop ([k (- (length hints))] [used '()] [in-domain 0] [starts '()])
    (define limit (if (null? used) more-tries tries))
    (cond
      [(and (= k limit) (null? used) (pair? starts))
       (define holds (holding sides given assumed point-of))
       (define found
         (for/or ([start (in-list starts)] [_ (in-range climbs)])
           (climb start holds (length assumed))))
       (when found (visit found (point-of found)))
       (survey (if found (list found) '()) in-domain)]
      [(or (= k limit) (= (length used) (+ enough (length hints)))) (survey used in-domain)]
      [else
       (define numbers
         (if (negative? k)
             (completed (list-ref hints (+ k (length hints))) symbols)
             (random-numbers symbols k constants)))
       (define where (make-point numbers (modulo k 5) decimal))
       (cond [(not (in-question? sides given where)) (loop (+ k 1) used in-domain starts)]
             [(not (all-hold? assumed where flonum-intervals))
              (loop (+ k 1) used (+ in-domain 1) (cons numbers starts))]
             [(visit numbers where) (survey (cons numbers used) (+ in-domain 1))]
             [else (loop (+ k 1) (cons numbers used) (+ in-domain 1) starts)])])))

;; -> numbers -> how many of the assumed relations hold there, #f outside of the question
(define ((holding sides given assumed point-of) numbers)
  (define where (point-of numbers))
  (and (in-question? sides given where)
       (for/sum ([r (in-list assumed)]) (if (all-hold? (list r) where flonum-intervals) 1 0))))

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
                   (set! found (or found (beyond-rounding (list e simple)
                                                          (difference-at e simple numbers where))))
                   found)))
  (or found
      (judge-form-survey s (list e) given assumed)
      (and (eqv? defined 0)
           (if (for/and ([numbers (in-list (survey-used s))])
                 (and (surely-undefined? simple numbers) (roomy? e given numbers)))
               (fault 'result-nowhere-defined (car (survey-used s)) #f #f)
               'unjudged))))

;; Decimals are rounded where numbers are put together; -> f, or #f
(define (beyond-rounding es f)
  (define-values (u v) (if f (values (fault-left f) (fault-right f)) (values 0 0)))
  (and f
       (or (not (decimals? es)) (> (abs (- u v)) (* 1e-9 (+ (abs u) (abs v)))))
       f))

;; Of what is nowhere defined every form is right.
(define (judge-form-survey s sides given assumed)
  (if (eqv? 0 (survey-in-domain s)) 'unjudged (judge-survey s sides given assumed)))

;; Has e values near the point, too?  Else it is the brim of where it has values.
(define (roomy? e given numbers)
  (for/or ([_ (in-range 12)])
    (in-question? (list e) given
                  (make-point (for/hasheq ([(s x) (in-hash numbers)])
                                (values s (+ x (/ (- (random 2001) 1000) 1000000000))))
                              0))))

(define (surely-undefined? e numbers)
  (no-value? (value-at e (make-point numbers 0) sharp)))

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
