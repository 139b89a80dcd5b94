#lang racket/base
;; Formulas over vectors: the code has the bits that flonums of Racket have, component by component.

(require racket/flonum
         mechanics/numeric/machine/assembler
         mechanics/numeric/machine/elements
         mechanics/numeric/machine/executable
         "../../support/checks.rkt"
         "../../support/machine-run.rkt" "../../support/random.rkt" "../../support/skip.rkt")

;; Vectors u, v, w behind each other; the number h.
(define h 0.37)

(define (random-formula depth)
  (define (sub) (random-formula (- depth 1)))
  (if (or (zero? depth) (zero? (random 5)))
      (random-choice '(at u i) '(at v i) '(at w i) 'h 1.25 '(fl/ 2.0 3.0))
      (case (random 8)
        [(0) `(fl+ ,(sub) ,(sub))]
        [(1) `(fl- ,(sub) ,(sub))]
        [(2 3) `(fl* ,(sub) ,(sub))]
        [(4) `(fl/ ,(sub) ,(sub))]
        [(5) `(flmax (flabs ,(sub)) (flabs ,(sub)))]
        [(6) `(flsqrt (flabs ,(sub)))]
        [else `(weighted i [,(random-flonum) u] [(fl/ 1.0 ,(random-flonum)) v]
                         [,(random-flonum) w])])))

;; value : name -> what it stands for
(define (evaluate f value)
  (define (of f) (evaluate f value))
  (cond [(real? f) f]
        [(symbol? f) (value f)]
        [else
         (case (car f)
           [(at) (value (cadr f))]
           [(fl+) (fl+ (of (cadr f)) (of (caddr f)))]
           [(fl-) (fl- (of (cadr f)) (of (caddr f)))]
           [(fl*) (fl* (of (cadr f)) (of (caddr f)))]
           [(fl/) (fl/ (of (cadr f)) (of (caddr f)))]
           [(flmax) (flmax (of (cadr f)) (of (caddr f)))]
           [(flabs) (flabs (of (cadr f)))]
           [(flsqrt) (flsqrt (of (cadr f)))]
           [(weighted)
            (for/fold ([sum #f]) ([p (in-list (cddr f))])
              (define x (fl* (of (car p)) (value (cadr p))))
              (if sum (fl+ sum x) x))])]))

(define (check-elements n f)
  (define input (build-flvector* (+ 2 (* 3 n))))
  (flvector-set! input 0 h)
  (flvector-set! input 1 h)
  (define (component name i)
    (if (eq? name 'h) h (flvector-ref input (+ 2 i (* n (case name [(u) 0] [(v) 1] [else 2]))))))
  (define run
    (machine-run
     (lambda (a)
       (emit-elements! a n
                       (hasheq 'h (behind rdi 0)
                               'u (vector-at rdi 16) 'v (vector-at rdi (* 8 (+ 2 n)))
                               'w (vector-at rdi (* 8 (+ 2 n n)))
                               'out (vector-at rsi 0) 'squares (vector-at rsi (* 8 n)))
                       `((x ,f) (out x) (squares (fl* x x))))
       (ret! a))))
  (define out (make-flvector (+ n n 1) 99.0))
  (run input out)
  (define values
    (for/list ([i (in-range n)]) (evaluate f (lambda (name) (component name i)))))
  (check-equal? (for/list ([x (in-flvector out)]) x)
                (append values (for/list ([x (in-list values)]) (fl* x x)) '(99.0))))

(define (build-flvector* n) (for/flvector #:length n ([_ (in-range n)]) (random-flonum)))

(skip-unless (machine?) "no processor that machine code is written for"
  (test-case "random formulas, of few components and many"
    (with-seeds 60
      (define f (random-formula 4))
      (for ([n (in-list '(1 2 3 5 8 9 10 17 40))])
        (with-check-info (['formula f] ['n n]) (check-elements n f))))))
