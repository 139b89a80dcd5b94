#lang racket/base
;; Finding the kernels of an expression.
;;
;; One walk over the graph meets every node that is not arithmetic and decides
;; what stands for it: a kernel of its own, the sine or cosine of an angle, or
;; a root.  Kernels whose canonical expressions are equal are one kernel.
;; Angles are gathered as linear forms over *atoms* (the terms they are sums
;; of); when all are known, a lattice basis of them gives the basic angles, and
;; only angles that depend on others get expanded later.
;;
;; Arguments of kernels are simplified first, by the procedures of `services`,
;; which belong to the simplifier above.

(require "operation.rkt" "expression.rkt" "kernel.rkt" "lattice.rkt" "order.rkt" "exact.rkt"
         "services.rkt" "circle.rkt")

(provide (struct-out atlas)
         (struct-out circular) (struct-out surd) (struct-out alias) imaginary-unit
         collect-kernels)

;; What was found.  resolutions : node, symbol, +i, or number
;; that is not rational -> kernel, circular, surd or alias; roots : those in the radicands
;; of others after them; doubled : circles of which twice the angle occurred;
;; inexact? : did a flonum occur?
(struct atlas (kernels resolutions roots doubled inexact? services)
  #:authentic)

;; What stands for a node: function ∈ sin cos tan of an angle;
(struct circular (function angle)
  #:authentic)
;; outer^power · root^power;
(struct surd (outer root power)
  #:authentic)
;; another expression.
(struct alias (expression)
  #:authentic)

;; ---------------------------------------------------------------------------
;; The walk

(struct collector (services root blocked kernels resolutions atoms angles roots
                   [root-list #:mutable] [inexact? #:mutable])
  #:authentic)

;; blocked : nodes to be taken as they simplify by themselves, not expanded; if e
;; is one, its operands are simplified.
(define (collect-kernels e services [blocked '()])
  (define c (collector services e blocked (make-hash) (make-hasheqv) (make-atoms)
                       (make-hash) (make-hash) '() #f))
  (visit! c e)
  (settle-angles! c)
  (atlas (hash-values (collector-kernels c))
         (collector-resolutions c)
         (collector-root-list c)
         (doubled-circles c)
         (collector-inexact? c)
         services))

(define (visit! c e)
  (cond [(number? e) (visit-number! c e)]
        [(hash-ref (collector-resolutions c) e #f) (void)]
        [(symbol? e) (resolve! c e (intern-kernel! c e))]
        [else
         (hash-set! (collector-resolutions c) e #t)
         (if (memq e (collector-blocked c))
             (visit-blocked! c e)
             (visit-node! c e))]))

;; What a blocked node simplifies to stands for it; a sum as one kernel.
(define (visit-blocked! c n)
  (define simple
    (if (eq? n (collector-root c))
        (simplify-arguments c n)
        ((services-simplify (collector-services c)) n)))
  (cond [(and (node? simple) (memq (node-head simple) (list op:+ op:- (node-head n))))
         (resolve! c n (intern-kernel! c simple))]
        [else
         (visit! c simple)
         (resolve! c n (alias simple))]))

(define (visit-number! c e)
  (cond [(exact-constant? e)
         (unless (exact? e) (set-collector-inexact?! c #t))
         (unless (real? e)
           (resolve! c imaginary-unit (root-kernel (intern-root! c -1 2))))]
        [else (resolve! c e (intern-kernel! c e))]))

(define (visit-node! c n)
  (define head (node-head n))
  (define args (node-args n))
  (cond [(literal-head? head) (visit-kernel! c n)]
        [(memq head arithmetic) (visit-all! c args)]
        [(eq? head op:expt) (visit-power! c n (car args) (cadr args))]
        [(eq? head op:sqrt) (visit-root! c n (car args) 1/2)]
        [(memq head circular-heads) (visit-angle! c n 1)]
        [(memq head hyperbolic-heads) (visit-angle! c n -1)]
        [else (visit-kernel! c n)]))

(define arithmetic (list op:+ op:- op:* op:/))
(define circular-heads (list op:sin op:cos op:tan))
(define hyperbolic-heads (list op:sinh op:cosh op:tanh))

(define (visit-all! c es)
  (for ([e (in-list es)]) (visit! c e)))

;; ---------------------------------------------------------------------------
;; Kernels of their own

(define (resolve! c n resolution)
  (hash-set! (collector-resolutions c) n resolution))

(define (intern-kernel! c expression [relation #f])
  (define kernels (collector-kernels c))
  (or (hash-ref kernels expression #f)
      (let ([k (make-kernel expression relation)])
        (hash-set! kernels expression k)
        k)))

(define (visit-kernel! c n)
  (resolve! c n (intern-kernel! c (simplify-arguments c n))))

;; n with its arguments simplified; structured arguments by components.
(define (simplify-arguments c n)
  (define args (node-args n))
  (define simple (for/list ([a (in-list args)]) (simplify-argument c a)))
  (if (andmap eq? args simple) n (make-node (node-head n) simple)))

(define (simplify-argument c a)
  (cond [(not (node? a)) a]
        [(memq (node-head a) (list op:up op:down)) (simplify-arguments c a)]
        [else ((services-simplify (collector-services c)) a)]))

;; ---------------------------------------------------------------------------
;; Powers and roots

(define (visit-power! c n base exponent)
  (define k (exact-exponent exponent))
  (cond [(not k) (visit-kernel! c n)]
        [(integer? k) (visit! c base)]
        [else (visit-root! c n base k)]))

(define (visit-root! c n base k)
  (define-values (outer inner)
    ((services-split-root (collector-services c)) base (denominator k)))
  (visit! c outer)
  (resolve! c n
            (surd outer
                  (and (not (eqv? inner 1)) (intern-root! c inner (denominator k)))
                  (numerator k))))

(define (intern-root! c radicand degree)
  (define roots (collector-roots c))
  (define key (cons degree radicand))
  (or (hash-ref roots key #f)
      (let ([r (root radicand degree #f)])
        (visit! c radicand)
        (hash-set! roots key r)
        (set-collector-root-list! c (cons r (collector-root-list c)))
        (set-root-kernel! r (intern-kernel! c (root-expression radicand degree) r))
        r)))

(define (root-expression radicand degree)
  (cond [(not (eqv? degree 2)) (make-node op:expt (list radicand (/ 1 degree)))]
        [(eqv? radicand -1) imaginary-unit]
        [else (make-node op:sqrt (list radicand))]))

(define imaginary-unit +i)

;; ---------------------------------------------------------------------------
;; Angles

;; Atoms are numbered as they come: expression -> key, and key -> expression.
(struct atoms (keys expressions) #:authentic)
(define (make-atoms) (atoms (make-hash) (make-hasheqv)))

(define (atom-key! table e)
  (define keys (atoms-keys table))
  (or (hash-ref keys e #f)
      (let ([k (hash-count keys)])
        (hash-set! keys e k)
        (hash-set! (atoms-expressions table) k e)
        k)))

(define (visit-angle! c n sign)
  (define form (linear-form c (car (node-args n))))
  (define table (collector-angles c))
  (define key (cons sign form))
  (define a
    (or (hash-ref table key #f)
        (let ([a (angle form #f)])
          (hash-set! table key a)
          a)))
  (resolve! c n (circular (node-head n) a)))

(define (linear-form c u)
  (define table (collector-atoms c))
  (define (vector coefficient e) (list (cons (atom-key! table e) coefficient)))
  (cond [(symbol? u) (vector 1 u)]
        [else
         (for/fold ([form '()])
                   ([t (in-list ((services-terms (collector-services c)) u))])
           (vector-add form (vector (car t) (cdr t))))]))

;; Basic angles for each sign, and every angle as a combination of them.
(define (settle-angles! c)
  (for ([sign (in-list '(1 -1))])
    (define angles
      (for/list ([(key a) (in-hash (collector-angles c))] #:when (eqv? (car key) sign)) a))
    (unless (null? angles) (settle-circles! c sign angles))))

(define (settle-circles! c sign angles)
  (define ordered (sort-angles c angles))
  (define-values (basis coordinates) (integer-basis (map angle-form ordered)))
  (define basics (for/vector ([form (in-list basis)]) (basic-angle c sign form)))
  (for ([a (in-list ordered)] [v (in-list coordinates)])
    (set-angle-multiples! a
      (for/list ([x (in-list v)])
        (define basic (vector-ref basics (car x)))
        (cons (car basic) (* (cdr basic) (cdr x)))))))

;; The basic angles that occurred doubled.
(define (doubled-circles c)
  (for*/list ([a (in-hash-values (collector-angles c))]
              [multiples (in-value (angle-multiples a))]
              #:when (and (pair? multiples) (null? (cdr multiples))
                          (eqv? 2 (abs (cdar multiples)))))
    (caar multiples)))

;; The simplest first: fewest atoms, then by the order of expressions.
(define (sort-angles c angles)
  (cond [(null? (cdr angles)) angles]
        [else
         (define compare (make-order))
         (define entries
           (for/list ([a (in-list angles)])
             (vector (length (angle-form a)) (form->expression c (angle-form a)) a)))
         (define (simpler? a b)
           (define k (- (vector-ref a 0) (vector-ref b 0)))
           (or (< k 0)
               (and (eqv? k 0)
                    (< (compare (vector-ref a 1) (vector-ref b 1)) 0))))
         (for/list ([entry (in-list (sort entries simpler?))]) (vector-ref entry 2))]))

(define (form->expression c form)
  (define expressions (atoms-expressions (collector-atoms c)))
  (for/fold ([sum 0]) ([entry (in-list form)])
    (e:+ sum (e:* (cdr entry) (hash-ref expressions (car entry))))))

(define (basic-angle c sign form)
  (signed-circle (collector-services c) (form->expression c form)
                 (lambda (u) (make-circle u sign (lambda (e o) (intern-kernel! c e o))))))
