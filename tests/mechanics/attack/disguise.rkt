#lang racket/base
;; Rewrites that change nothing wherever both sides have values, and wrong ones.

(require racket/match
         "statement.rkt")

(provide disguised disguise-once spoiled rewritten-somewhere)

;; e after some sound rewrites, each at a random place.
(define (disguised e [steps 2])
  (for/fold ([e e]) ([_ (in-range steps)]) (disguise-once e)))

(define (disguise-once e) (rewritten-somewhere e sound))

;; rewrite : S-expression -> S-expression or #f; tried at random places.
(define (rewritten-somewhere e rewrite [tries 8])
  (or (for/or ([_ (in-range tries)]) (rewritten-at-random e rewrite))
      e))

(define (rewritten-at-random e rewrite)
  (cond [(and (pair? e) (not (chance 3)))
         (define i (random (length (cdr e))))
         (define fixed? (and (eq? (car e) 'expt) (eqv? i 1)))   ; exponents stay
         (define new (and (not fixed?) (rewritten-at-random (list-ref (cdr e) i) rewrite)))
         (and new
              (cons (car e) (for/list ([a (in-list (cdr e))] [k (in-naturals)])
                              (if (eqv? k i) new a))))]
        [else (rewrite e)]))

(define (small) (pick '(1 2 3 1/2 -1 -2 2/3)))

;; Rewrites true of real numbers without any condition.
(define (sound e)
  (match e
    [`(- ,u ,v) (pick (list `(- (- ,v ,u)) `(+ ,u (* -1 ,v)) `(/ (- (* 2 ,u) (* 2 ,v)) 2)))]
    [`(+ ,u ,v) (pick (list `(+ ,v ,u) `(- ,u (- ,v))))]
    [`(* ,u (+ ,v ,w)) `(+ (* ,u ,v) (* ,u ,w))]
    [`(* ,u ,v) (pick (list `(* ,v ,u) `(/ (- (square (+ ,u ,v)) (square (- ,u ,v))) 4)))]
    [`(/ ,u ,v) (pick (list `(* ,u (expt ,v -1))
                            (let ([c (small)]) `(/ (* ,u ,c) (* ,c ,v)))))]
    [`(square (+ ,u ,v)) `(+ (square ,u) (* 2 ,u ,v) (square ,v))]
    [`(square ,u) `(* ,u ,u)]
    [`(sin ,u) (pick (list `(* 2 (sin (* 1/2 ,u)) (cos (* 1/2 ,u))) `(- (sin (- ,u)))
                           `(* (sin ,u) (+ (square (sin ,u)) (square (cos ,u))))))]
    [`(cos ,u) (pick (list `(- 1 (* 2 (square (sin (* 1/2 ,u))))) `(cos (- ,u))
                           `(- (* 2 (square (cos (* 1/2 ,u)))) 1)))]
    [`(exp ,u) (pick (list `(square (exp (* 1/2 ,u))) `(/ 1 (exp (- ,u)))
                           `(+ (cosh ,u) (sinh ,u))))]
    [`(abs ,u) `(abs (- ,u))]
    [(? number?) #f]
    [u (pick (list (let ([c (small)]) `(- (+ ,u ,c) ,c))
                   `(* ,u (+ (square (sin ,u)) (square (cos ,u))))
                   `(/ (+ ,u ,u) 2) `(- (* 3 ,u) (* 2 ,u))
                   `(/ (* ,u (+ 1 (square x))) (+ 1 (square x)))))]))

;; e with a small fault.
(define (spoiled e) (rewritten-somewhere e wrong))

(define (wrong e)
  (match e
    [`(- ,u ,v) `(- ,v ,u)]
    [`(sin ,u) `(sin (- ,u))]
    [`(/ ,u ,v) `(/ ,v ,u)]
    [(? pair? u) (pick (list `(- ,u) `(* ,u 2) `(abs ,u) `(+ ,u 1/1000000000000)))]
    [u #f]))
