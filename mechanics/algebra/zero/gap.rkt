#lang racket/base
;; Gaps: surfaces where expressions have no value and stay bounded, so that they may jump there.
;;
;; k/|x| has no value at 0 and grows beyond all bounds on both sides: no motion passes.  x/|x| has
;; none either, and is a step; atan(1/x) jumps by π.  So a surface without values is a gap unless
;; something is unbounded on both sides of it.
;;
;; A quotient of functions that are analytic at the surface needs no test: it is unbounded, or has a
;; value to which it leads, as (sin x)/x has.  Else there is a *critical part*, an argument of a
;; function that is no arithmetic, which has no value there or at which the function turns: x in
;; x/|x|, 1/x in atan(1/x).
;;
;; The test takes places on the surface, and points that come nearer to each from both sides.
;; They are 2⁻²⁰, 2⁻²⁴ … away: a power of the distance grows at them by more with every step, a
;; logarithm by the same, and a bounded function by less and less.

(require racket/list
         "assignment.rkt" "region.rkt" "zero-surface.rkt"
         "../assumption/assumption-set.rkt" "../assumption/domain.rkt" "../assumption/signs.rkt"
         (except-in "../ball/ball.rkt" unknown) "../ball/ball-tape.rkt" "../ball/ball-value.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/nodes.rkt" "../expression/operation.rkt" "../expression/symbols.rkt")

(provide gaps)

;; es : expressions                      variables : symbols, of which a surface has one
;; surface? : factor -> may it vanish, and change its sign there?
;; -> ((node . zero) ...): a part without a value, and the factor that vanishes there
(define (gaps es variables surface? A)
  (define critical (append-map critical-parts es))
  (define (passable? f)
    (passes-through? f variables (map expression->tape es) (map expression->tape critical)
                     (make-region A (expression->tape (make-node op:up es)))))
  (if (null? critical)
      '()
      (remove-duplicates
       (for*/list ([e (in-list es)]
                   [n (in-list (nodes-in e))]
                   [f (in-list (surfaces-of (excluding-zero n) variables A))]
                   #:when (and (surface? f) (passable? f)))
         (cons n f))
       #:key cdr)))

;; -> the factors of all that vary; |u| and √u vanish where u does
(define (surfaces-of us variables A)
  (remove-duplicates
   (let walk ([us us])
     (for*/list ([u (in-list us)]
                 [f (in-list (surfaces u variables A))]
                 [zero (in-list (if (root-or-size? (surface-zero f))
                                    (walk (node-args (surface-zero f)))
                                    (list (surface-zero f))))])
       zero))))

(define (root-or-size? e) (or (headed? e op:abs) (headed? e op:sqrt)))

;; Expressions that may not be 0 if n is to have a value
(define (excluding-zero n)
  (for/list ([r (in-list (node-relations n))] #:unless (signs-within? zero (relation-signs r)))
    (relation-expression r)))

;; At whose zeros a function in e is not analytic
(define (critical-parts e)
  (append*
   (for/list ([n (in-list (nodes-in e))] #:unless (arithmetic-node? n))
     (append (turning-parts n)
             (append-map excluding-zero (append-map nodes-in (node-args n)))))))

(define (turning-parts n)
  (define-values (head args) (values (node-head n) (node-args n)))
  (cond [(memq head (list op:abs op:sgn op:expt)) (list (car args))]
        [(eq? head op:atan) (if (pair? (cdr args)) (list (car args)) '())]
        [(eq? head op:tan) '()]
        [else (map relation-expression (node-relations n))]))

;; ---------------------------------------------------------------------------
;; Places on a surface

;; Is there a place on it where both sides have values, some part is critical, and nothing is
;; unbounded on one side?
(define (passes-through? f variables es critical place)
  (define t (expression->tape f))
  (for*/or ([source (in-list sources)]
            [v (in-list (filter (lambda (v) (occurs? v f)) variables))]
            [at (in-value (line v place (source)))]
            [x (in-list (zeros-on (lambda (x) (tape-value t (at x) precision))))])
    (define (near distance) (at (+ x distance)))
    (define (beside distance) (at (- x distance)))
    (and (for*/and ([side (in-list (list near beside))]
                    [distance (in-list (list first-distance last-distance))])
           (inside? es place (side distance)))
         (ormap (lambda (u) (not (stays-away? u near))) critical)
         (for/or ([side (in-list (list near beside))])
           (not (ormap (lambda (t) (unbounded? t side)) es))))))

(define sources
  (for/list ([make (in-list (list integers-from fractions-from integers-from fractions-from))]
             [k (in-list '(2 8 -3 -9))])
    (lambda () (make k))))

;; x -> lookup, with x for the variable v and numbers of the source for all else; a literal
;; function is a constant, so that it leads to a value everywhere
(define (line v place next)
  (define others (make-hash))
  (define ((at x) leaf arguments)
    (if (eq? leaf v)
        x
        (hash-ref! others (if (symbol? leaf) leaf (node-head leaf))
                   (lambda () (region-place place leaf (next))))))
  at)

(define (inside? es place lookup)
  (and (region-admits? place lookup precision)
       (for/and ([t (in-list es)]) (not (eq? no-value (tape-value t lookup precision))))))

;; sign changes of the function between these numbers
(define grid '(-1000 -50 -21/2 -5 -16/5 -2 -4/3 -2/3 -1/4 1/4 2/3 4/3 2 16/5 5 21/2 50 1000))

(define (zeros-on value)
  (define (sign x)
    (define v (value x))
    (if (symbol? v) 0 (signs->number (value-signs v))))
  (define signs (map sign grid))
  (append*
   (for/list ([low (in-list grid)] [high (in-list (cdr grid))]
              [s (in-list signs)] [next (in-list (cdr signs))])
     (cond [(eqv? s 0) (if (eqv? 0 (value low)) (list low) '())]
           [(eqv? s (- next)) (list (bisect sign low high s))]
           [else '()]))))

(define (signs->number signs) (cond [(eqv? signs positive) 1] [(eqv? signs negative) -1] [else 0]))

;; s : the sign at low
(define (bisect sign low high s)
  (let loop ([low low] [high high])
    (define x (/ (+ low high) 2))
    (define there (sign x))
    (cond [(or (eqv? there 0) (< (- high low) root-error)) x]
          [(eqv? there s) (loop x high)]
          [else (loop low x)])))

(define root-error (expt 2 -90))
(define precision 240)

;; ---------------------------------------------------------------------------
;; Nearer and nearer

(define distances (for/list ([n (in-range 20 45 4)]) (expt 2 (- n))))
(define first-distance (first distances))
(define last-distance (last distances))

;; at : distance -> lookup.  Does the value change in one direction, by no less than before?
(define (unbounded? t at)
  (define found (for/list ([d (in-list distances)]) (number (tape-value t (at d) precision))))
  (and (andmap values found)
       (let ([steps (for/list ([a (in-list found)] [b (in-list (cdr found))]) (- b a))])
         (and (or (andmap positive? steps) (andmap negative? steps))
              (for/and ([a (in-list steps)] [b (in-list (cdr steps))])
                (>= (abs b) (* 999/1000 (abs a))))))))

;; Does it not come nearer to 0?
(define (stays-away? t at)
  (define-values (far near)
    (values (number (tape-value t (at first-distance) precision))
            (number (tape-value t (at last-distance) precision))))
  (and far near (> (* 2 (abs near)) (abs far))))

;; -> an exact number, or #f of a value that is not known to so many digits
(define (number v)
  (cond [(symbol? v) #f]
        [(not (ball? v)) v]
        [(> (abs (ball-scale v)) most-scale) #f]
        [(> (* most-error (ball-radius v)) (abs (ball-middle v))) #f]
        [else (* (ball-middle v) (expt 2 (ball-scale v)))]))

(define most-scale 100000)
(define most-error (expt 10 8))
