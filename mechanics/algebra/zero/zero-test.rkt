#lang racket/base
;; Is an expression zero?  Proved, refuted, or undecided.
;;
;; *Proved* rests on the canonical form being 0, whatever numbers stand in place of
;; the flonums (flonum-independence.rkt).  *Refuted* rests on a point where the value is proved not
;; to be zero (witness.rkt): small integers, or fractions, for the symbols and for the
;; literal functions applied, which a person can put in by hand; all assumptions hold
;; there.  Otherwise the test is *undecided* and says at how many points it found zero,
;; and to which bound.  The points are always the same.
;;
;; A large graph is first judged modulo primes (fingerprint.rkt): if it is not
;; zero, a point is found for it as it stands, and it is expanded only when its
;; residual is asked for.  If it is zero there, proofs are tried (proof.rkt); should
;; none be found, the test is undecided, with a bound of 0 at those points.  The
;; roots there are those of positive numbers: under assumptions they decide nothing.

(require racket/list
         "condition.rkt" "decimal-readings.rkt" "readable-equation.rkt" "vanishing-factors.rkt"
         "existence.rkt" "fingerprint.rkt" "flonum-independence.rkt" "proof.rkt"
         "real-proof.rkt" "region.rkt" "witness.rkt"
         "../assumption/assumption-set.rkt" "../assumption/reference-point.rkt"
         "../assumption/relation.rkt"
         (only-in "../assumption/signs.rkt" signs-within? zero)
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/operation.rkt" (only-in "../expression/simplifier.rkt" left-unexpanded?)
         (only-in "../expression/symbols.rkt" symbols-in)
         "../field/work-bounds.rkt" (only-in "../field/field.rkt" field-atlas)
         (only-in "../kernel/find-kernels.rkt" atlas-simplifier)
         "../polynomial/fraction.rkt"
         "../simplify/necessary-assumptions.rkt" "../simplify/simplify-expression.rkt"
         "../../error/computed-once.rkt")

(provide zero-test
         zero-test-status zero-test-residual zero-test-witness zero-test-value
         zero-test-bound zero-test-points zero-test-reason zero-test-decimals
         zero-test-factor zero-test-core
         zero-test-conditions zero-test-ways zero-test-left-unexpanded
         zero-test-grounds zero-test-assumptions zero-test-as-read zero-test-in-doubt)

;; status : 'proved, 'refuted or 'undecided
;; witness : #f or ((expression . number) ...)  value : the residual's there
;; bound : the greatest rounding error at the points tried without a decision; 0 if
;; those were points modulo primes
;; points : how many those were
;; reason : why it is undecided: 'nowhere if no point was found where it has a value,
;; 'decimals if it vanishes but for these, 'rounding for a flonum as small as rounding
;; leaves; or #f
;; decimals : readings (decimal-readings.rkt): those a proof rests on, those that stand in the way
;; form : a form, or a procedure that makes it
(struct zero-test (status witness value bound points reason decimals form)
  #:name zero-test-result
  #:constructor-name make-zero-test)

;; residual : expression, simplified             factor, core : residual = factor · core
;; conditions : equations, as data, for which core = 0
;; ways : -> lists of equations, each of which makes the residual 0
;; grounds : datums, such as (>= R 0), of the residual; or a procedure that finds them
;; unexpanded : expressions that would have grown too large
(struct form (residual factor core conditions ways grounds unexpanded) #:authentic)

(define (zero-test-residual z) (form-residual (settled-form z)))
(define (zero-test-factor z) (form-factor (settled-form z)))
(define (zero-test-core z) (form-core (settled-form z)))
(define (zero-test-conditions z) (form-conditions (settled-form z)))
(define (zero-test-ways z) ((form-ways (settled-form z))))
(define (zero-test-grounds z) (form-grounds (settled-form z)))
(define (zero-test-assumptions z) (at-last (zero-test-grounds z)))
(define (zero-test-left-unexpanded z) (form-unexpanded (settled-form z)))

(define (settled-form z) (at-last (zero-test-form z)))

;; The same proof, of the expression with these decimals
(define (zero-test-as-read z readings) (struct-copy zero-test-result z [decimals readings]))
;; A proof that is none, for decimals may have been rounded
(define (zero-test-in-doubt z readings)
  (struct-copy zero-test-result z [status 'undecided] [reason 'decimals] [decimals readings]))

(define (make-form e A variables)
  (if (and (number? e) (not (rational? (magnitude e))))
      (form e 1 e '() no-ways '() '())
      (make-form-of-finite e A variables)))

(define (make-form-of-finite e A variables)
  (define-values (F f simple notes) (normal-form+simplified e A))
  (define-values (left assumed) (partition left-unexpanded? notes))
  (define grounds (needed-grounds e (if (fraction-zero? f) 0 simple) A assumed))
  (define unexpanded (map cadr left))
  (cond [(fraction-zero? f) (form 0 1 0 '() no-ways grounds unexpanded)]
        [(and (readable? f) (null? unexpanded))
         (define (may-be-0? p) (may-vanish? A F p))
         (define-values (factor core equations)
           (if (holds-sum? simple)
               (factor-and-core F f variables may-be-0?)
               (values 1 simple '())))
         (define conditions (if (real-equations? equations) equations '()))
         (form simple factor core conditions
               (once
                (lambda ()
                  (with-first conditions
                              (filter real-equations?
                                      (ways-to-vanish
                                       F f
                                       (lambda (e) (constant-expression? e variables))
                                       may-be-0?)))))
               grounds
               '())]
        [else (form simple 1 simple '() no-ways grounds unexpanded)]))

(define (no-ways) '())

;; Symbols are real: x = 3/i says nothing.
(define (real-equations? equations)
  (define (real-leaf? d) (if (pair? d) (andmap real-leaf? d) (or (symbol? d) (real? d))))
  (andmap real-leaf? equations))

(define (with-first way ways)
  (if (null? way)
      ways
      (cons way (remove way ways same-equations?))))

;; Has a product or quotient a sum among its factors?  Else, as in -5 b sin 3t, there
;; is no core.
(define (holds-sum? e)
  (and (node? e)
       (cond [(memq (node-head e) (list op:* op:/ op:expt)) (ormap holds-sum? (node-args e))]
             [else (memq (node-head e) (list op:+ op:-))])
       #t))

;; Do the assumptions allow the expression over F to be zero?
(define (may-vanish? A F e)
  (define k (infer-signs A (atlas-simplifier (field-atlas F)) e))
  (signs-within? zero (known-signs k)))

;; ---------------------------------------------------------------------------
;; The test

;; A : assumptions the expression is judged under
;; variables : symbols that no condition may speak of, such as the time of a path
(define (zero-test e [A no-assumptions] [variables '()])
  (or (and (number? e) (inexact? e) (test-flonum e A))
      (test-if-enormous e A variables (expression->plain-tape e))
      (let* ([t (expression->tape e)] [z (test-expression e A variables t)])
        (if (and (eq? (zero-test-status z) 'undecided) (contains-flonum? t))
            (test-as-read e A variables t z)
            z))))

;; z : the undecided test with the decimals as they stand.  As they are read there
;; may be a proof, and it tells how they were read.  Numbers alone prove nothing, nor do
;; readings that make different decimals one.
(define (test-as-read e A variables t z)
  (define-values (read unread) (partition reading-expression (read-decimals (decimals-in t))))
  (define exact (with-decimals-read e read))
  (define other
    (and (pair? read)
         (speaks-of-symbols? t)
         (all-different? read)
         (test-expression exact A variables (expression->tape exact))))
  (if (and other (eq? (zero-test-status other) 'proved))
      (struct-copy zero-test-result other [decimals read])
      (struct-copy zero-test-result z [decimals (append read unread)])))

;; A flonum that stands alone does not tell of which numbers it is the difference; one
;; this small may be the rounding of numbers about 1.  Infinity is not
;; zero, and of NaN nothing can be said.
;; -> a verdict, or #f for an ordinary flonum
(define (test-flonum x A)
  (define size (magnitude x))
  (define form (later x A '()))
  (cond [(< size 1e-14) (make-zero-test 'undecided #f x size 1 'rounding '() form)]
        [(eqv? size +inf.0) (make-zero-test 'refuted '() x 0 0 #f '() form)]
        [(rational? size) #f]
        [else (make-zero-test 'undecided #f x 0 0 #f '() form)]))

(define (later e A variables) (once (lambda () (make-form e A variables))))

;; More items than `middling` are judged by the fingerprint first.  No more than
;; `large` are expanded even if they do not vanish: a witness then names only leaves
;; of the residual.
(define middling 300)
(define large 2000)

;; Graphs of more nodes than these are asked before equal nodes are looked for, which
;; takes longer than to see that most residuals do not vanish.
(define enormous 20000)

;; -> a refutation, or #f
(define (test-if-enormous e A variables t)
  (and (> (tape-length t) enormous)
       (eq? (tape-fingerprint t) 'nonzero)
       (refute-at-once e A variables t)))

(define (test-expression e A variables t)
  (define n (tape-length t))
  (define print (if (> n middling) (tape-fingerprint t) 'unknown))
  (or (and (eq? print 'nonzero) (> n large) (refute-at-once e A variables t))
      (and (eq? print 'zero) (prove-indirectly t A))
      (test-canonically e A variables t print)))

;; -> a refutation, or #f
(define (refute-at-once e A variables t)
  (define-values (witness value bound points)
    (find-witness t t (make-region A t) #f))
  (and witness
       (make-zero-test 'refuted witness value bound points #f '() (later e A variables))))

;; -> a proof, or #f.  It may rest on another expression, of which a sign was taken elsewhere:
;; its assumptions must hold at the reference point of this one.
(define (prove-indirectly t A)
  (define grounds (prove-vanishing t A))
  (and grounds
       (hold-at-reference? (taken-relations A grounds) t A)
       (vanishing-test t (form 0 1 0 '() no-ways grounds '()) A)))

(define (hold-at-reference? relations t A)
  (or (null? relations)
      (let ([lookup (find-reference (list (tape->expression t)) A)])
        (and lookup
             (for/and ([r (in-list relations)]) (holds-at? r lookup))))))

;; A proof must hold whatever the flonums are; without a value anywhere there is none.
(define (vanishing-test t f A)
  (define reason
    (cond [(and (contains-flonum? t) (not (vanishes-for-any-flonums? t A))) 'decimals]
          [(not (somewhere-defined? t A)) 'nowhere]
          [else #f]))
  (make-zero-test (if reason 'undecided 'proved) #f 0 0 0 reason '() f))

;; print : the answer of the fingerprint, if it was asked
(define (test-canonically e A variables t print)
  (define f (make-form e A variables))
  (cond [(eqv? (form-residual f) 0) (vanishing-test t f A)]
        [(and (eq? print 'zero) (null? (assumptions-relations A)))
         (make-zero-test 'undecided #f 0 0 fingerprint-points #f '() f)]
        [else (test-by-points A t f)]))

(define (test-by-points A t f)
  (define grounds (at-last (form-grounds f)))
  (define-values (witness value bound points)
    (find-witness t
                  (expression->tape (form-residual f))
                  (make-region A t (taken-relations A grounds))
                  (pair? grounds)))
  (cond [witness (make-zero-test 'refuted witness value bound points #f '() f)]
        [(and (eq? 'zero (tape-fingerprint t)) (prove-indirectly t A))]
        [(real-proof-form (tape->expression t) A) => (lambda (f) (vanishing-test t f A))]
        [else
         (define reason (and (zero? points) 'nowhere))
         (make-zero-test 'undecided #f value bound points reason '() f)]))

;; The form of an e that is proved to be zero among real numbers, or #f
(define (real-proof-form e A)
  (and (prove-among-reals e A) (form 0 1 0 '() no-ways (relations-about e A) '())))

;; Data of the relations in A on symbols of e: a proof among real numbers may rest on them all.
(define (relations-about e A)
  (define symbols (symbols-in e))
  (for/list ([r (in-list (assumptions-relations A))]
             #:when (ormap (lambda (s) (memq s symbols)) (symbols-in (relation-expression r))))
    (relation-datum r)))

;; The relations among the grounds that A does not hold.
(define (taken-relations A grounds)
  (define declared (map relation-datum (assumptions-relations A)))
  (for/list ([d (in-list grounds)] #:unless (member d declared)) (read-relation d)))
