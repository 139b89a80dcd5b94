#lang racket/base
;; Motions that an answer's equations allow and the key's do not.
;;
;; (x − 1)(x'' + x) = 0 holds along every motion, and for x = 1, too.  The answer's equations leave
;; accelerations open where a factor f vanishes: of the determinant of its mass matrix, or, for one
;; equation that is not linear, of its quotient by the key's.  Such states matter if some path stays
;; where f = 0 and is no motion.
;;
;; Where f = 0 the accelerations are a + s k, with those of motions, a, any number s, and k in the
;; kernel of the mass matrix.  Let D be the rate along motions.  A path with these accelerations
;; keeps f(t, q, v) = 0 if Df + s ∂f/∂v·k = 0, and is no motion unless Df = 0; or if both are 0
;; wherever f = 0, with any s.  If f depends on no velocity, Df = 0 is one more condition on the
;; state, and D²f + s ∂f/∂q·k = 0 decides in its place.
;;
;; States with f = 0 are looked for at several values of all other symbols.  A factor in which
;; functions are unknown stays unclear.

(require (only-in racket/flonum for/flvector)
         (only-in racket/list append-map argmax last range)
         racket/match
         "answer-parts.rkt" "decimal-answers.rkt" "prescribed-symbols.rkt" "written-answer.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/symbols.rkt"
         "../../algebra/solve/factors.rkt" "../../algebra/solve/solve-equations.rkt"
         "../../generic/arithmetic.rkt"
         (only-in "../../numeric/flvector.rkt" flvector->list)
         "../../numeric/linear-algebra/singular-values.rkt"
         (only-in "../../numeric/optimization/brent-root.rkt" bisected-root)
         "../../value/assumptions.rkt"
         "../../value/matrix/matrix.rkt"
         "../../value/read-expression.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt" "../../value/structure.rkt")

(provide extra-motion)

;; M : mass matrix of the answer; ratio : an expression whose zeros are looked at, in the symbols of
;; the long tuple; accelerations : of motions, a list
;; -> text, #f if none was found, or 'unclear
(define (extra-motion names M ratio accelerations)
  (define long (structure->list (long-tuple-of names)))
  (define-values (q v a) (apply values (map scalars (cdr long))))
  (define m (motion-equations q v a accelerations M))
  (define varying
    (for/list ([f (in-list (expression-factors (simplify ratio) (assumptions-in-force)))]
               #:when (and (positive? (cdr f)) (ormap (depends-on (car f)) (append q v a))))
      (car f)))
  (for/fold ([found #f]) ([f (in-list varying)] #:unless (string? found))
    (cond [(not (numeric? f)) 'unclear]
          [(allows-others? f m) (zero-text f m)]
          [else found])))

;; q, v, a : symbols; motion : the accelerations of motions
(struct motion-equations (q v a motion M))

(define ((depends-on f) s) (and (memq s (names-in-expression f)) #t))
(define (names-in-expression f) (if (expression? f) (symbols-in f) '()))

;; ---------------------------------------------------------------------------
;; Rates along motions

(define (partial-derivatives f symbols) (for/list ([s (in-list symbols)]) (rate f s)))

(define (dot xs ys) (apply g:+ 0 (map g:* xs ys)))

;; Df
(define (rate-along f m)
  (g:+ (rate f 't)
       (dot (partial-derivatives f (motion-equations-q m)) (motion-equations-v m))
       (dot (partial-derivatives f (motion-equations-v m)) (motion-equations-motion m))))

;; ---------------------------------------------------------------------------
;; States

(define (allows-others? f m)
  (define-values (q v a) (values (motion-equations-q m) (motion-equations-v m)
                                 (motion-equations-a m)))
  (define uses? (depends-on f))
  (define test
    (cond [(ormap uses? a) (other-acceleration? m)]
          [(ormap uses? v) (leaves-motions? (partial-derivatives f v) (rate-along f m) m)]
          [else (leaves-surface? f m)]))
  (define-values (last-one free?)
    (for*/fold ([result #f] [free? #t])
               ([i (in-range 8)]
                [y (in-list (filter uses? (append a v q)))]
                #:unless (eq? result 'other)
                [state (in-list (zeros f y (trial-state f m i)))]
                #:unless (eq? result 'other)
                #:when (and (regular? state m) (allowed? state)))
      (define r (test state))
      (values r (and free? (eq? r 'free)))))
  (or (eq? last-one 'other) (and last-one free?)))

;; Are the accelerations of motions finite?  Where r = 0 in polar coordinates they are not.
(define (regular? state m)
  (for/and ([a (in-list (motion-equations-motion m))])
    (define x (value-at a state))
    (and x (< (abs x) 1e6))))

(define (allowed? state)
  (for/and ([r (in-list (assumptions 'declared))])
    (define sides (for/list ([d (in-list (cdr r))]) (value-at (read-expression d) state)))
    (or (not (andmap values sides)) (apply (hash-ref relations (car r) (lambda () void)) sides))))

(define relations (hasheq '> > '< < '>= >= '<= <=))

(define ((other-acceleration? m) state)
  (define motion (value-at (car (motion-equations-motion m)) state))
  (and motion (differs? motion (cdr (assq (car (motion-equations-a m)) state))) 'other))

;; slopes : ∂f/∂v, or ∂f/∂q for its second rate; D : the rate along motions
;; -> 'other if a path leaves the motions, 'free if f = 0 is kept with any s, or #f
(define ((leaves-motions? slopes D m) state)
  (define found (value-at D state))
  (define k (kernel-at m state))
  (define along
    (and k (for/sum ([s (in-list slopes)] [x (in-list k)]) (* x (or (value-at s state) 0)))))
  (and found along
       (cond [(differs? along 0) (and (differs? found 0) 'other)]
             [else (and (not (differs? found 0)) 'free)])))

;; A velocity is chosen by which Df = 0.
(define (leaves-surface? f m)
  (define slopes (partial-derivatives f (motion-equations-q m)))
  (define D (rate-along f m))
  (define leaves? (leaves-motions? slopes (rate-along D m) m))
  (lambda (state)
    (define sizes (for/list ([s (in-list slopes)]) (or (value-at s state) 0)))
    (define i (argmax (lambda (i) (abs (list-ref sizes i))) (range (length sizes))))
    (define y (list-ref (motion-equations-v m) i))
    (define at-rest (with-value state y 0.0))
    (define rest (value-at D at-rest))
    (and rest (differs? (list-ref sizes i) 0)
         (leaves? (with-value state y (- (/ rest (list-ref sizes i))))))))

(define (differs? a b) (> (abs (- a b)) 1e-6))

;; A vector of length 1 that the mass matrix takes to 0, as it is singular there; or #f
(define (kernel-at m state)
  (define n (length (motion-equations-q m)))
  (define entries (for/list ([x (in-list (matrix-elements m))]) (value-at x state)))
  (define (column j)
    (for/flvector ([x (in-list entries)] [k (in-naturals)] #:when (= j (modulo k n))) x))
  (cond [(= n 1) '(1)]
        [(not (andmap values entries)) #f]
        [else
         (define-values (_us _sizes vs) (singular-values (map column (range n))))
         (flvector->list (last vs))]))

;; ---------------------------------------------------------------------------
;; Numbers

(define (numeric? f)
  (for/or ([i (in-range 8)]) (value-at f (state-with (names-in-expression f) i))))

;; Constants are positive; states lie anywhere.
(define (trial-state f m i)
  (define moving (append (motion-equations-q m) (motion-equations-v m) (motion-equations-a m)))
  (define others
    (append-map names-in-expression
                (cons f (append (motion-equations-motion m) (matrix-elements m)))))
  (append (for/list ([s (in-list moving)] [j (in-naturals 7)]) (cons s (- (* 4 (scattered i j)) 2)))
          (state-with (remq* moving others) i)))

(define (matrix-elements m)
  (define M (motion-equations-M m))
  (for*/list ([i (in-range (m:num-rows M))] [j (in-range (m:num-cols M))]) (matrix-ref M i j)))

(define (state-with names i)
  (for/list ([s (in-list names)] [j (in-naturals 1)]) (cons s (+ 0.4 (* 2 (scattered i j))))))

(define (with-value state s x) (cons (cons s x) state))

;; The states at which f changes its sign as s varies between -4 and 4
(define (zeros f s state)
  (define (at x) (value-at f (with-value state s x)))
  (for*/list ([i (in-range 80)]
              [zero (in-value (zero-between at (- (/ i 10.) 4.03) (- (/ (+ i 1) 10.) 4.03)))]
              #:when zero)
    (with-value state s zero)))

(define (zero-between at low high)
  (define-values (f g) (values (at low) (at high)))
  (and f g (< (* f g) 0)
       (let/ec return
         (define (value x) (or (at x) (return #f)))
         (define-values (zero _error _count) (bisected-root value low high))
         (and (< (abs (value zero)) 1e-6) zero))))

;; ---------------------------------------------------------------------------
;; Words

;; "for x = 1", or "where x² − y² − 1 = 0"
(define (zero-text f m)
  (define names (motion-equations-q m))
  (define unknowns
    (filter (depends-on f) (append (motion-equations-a m) (motion-equations-v m) names)))
  (define solutions
    (or (with-handlers ([exn:fail? (lambda (x) #f)])
          (solve-equations (list f) (list (car unknowns)) (assumptions-in-force)))
        '()))
  (define (text x) (formula-read names (expression->datum x)))
  (match solutions
    [`((((,name . ,x)))) (format "for ~a = ~a" (text name) (text (simplify x)))]
    [_ (format "where ~a = 0" (text f))]))
