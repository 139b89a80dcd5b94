#lang racket/base
;; The oracle: an arithmetic in which D is a central difference quotient.
;;
;; With enough digits there is nothing to it: a step h so small that h² is
;; nothing beside the tolerance, numbers so long that dividing by h a few times
;; leaves more digits than are looked at.  Nested derivatives are nested
;; quotients; the truncation error is a smooth function of everything and is
;; differentiated along with the rest.  A function-valued function has the
;; quotient of the values its value takes later: no ε, no tag, nothing to be
;; confused.

(require racket/list
         "language.rkt"
         "../bigfloats.rkt")

(provide rational-differences bigfloat-differences (struct-out tuple))

(struct tuple (orientation elements) #:transparent)

;; number     : written number -> number of this arithmetic
;; operations : name -> procedure of numbers: + - * / and the elementary ones
;; less?      : number number -> boolean.  close? : are they too close to compare?
;; h          : the step
;; watch      : number -> number, which discards programs whose numbers are no use
(define (differences number operations less? close? h watch)
  (define (op name)
    (define f (hash-ref operations name))
    (lambda args (watch (apply f args))))
  (define-values (add subtract multiply divide) (values (op '+) (op '-) (op '*) (op '/)))
  (define 2h (add h h))

  ;; Pointwise on functions, componentwise on tuples
  (define (lift f)
    (define (lifted . args)
      (cond [(ormap procedure? args)
             (lambda xs (apply lifted (for/list ([a args]) (if (procedure? a) (apply a xs) a))))]
            [(andmap tuple? args)
             (tuple (tuple-orientation (car args)) (apply map lifted (map tuple-elements args)))]
            [(ormap tuple? args) (discard "a tuple and a number")]
            [else (apply f args)]))
    lifted)
  (define (product a b)
    (cond [(and (tuple? a) (tuple? b)) (discard "a product of tuples")]
          [(and (tuple? b) (not (procedure? a)))
           (tuple (tuple-orientation b) (for/list ([y (tuple-elements b)]) (product a y)))]
          [else ((lift multiply) a b)]))

  (define (quotient-of a b)
    (cond [(procedure? a) (lambda xs (quotient-of (apply a xs) (apply b xs)))]
          [(tuple? a) (tuple (tuple-orientation a)
                             (map quotient-of (tuple-elements a) (tuple-elements b)))]
          [else (divide (subtract a b) 2h)]))

  (define (derivative-at f x)
    (cond [(tuple? x)
           (define elements (tuple-elements x))
           (tuple (flip (tuple-orientation x))
                  (for/list ([e elements] [i (in-naturals)])
                    (derivative-at
                     (lambda (y) (f (tuple (tuple-orientation x) (list-set elements i y))))
                     e)))]
          [else (quotient-of (f (add x h)) (f (subtract x h)))]))

  (define (derivative f)
    (lambda args
      (if (null? (cdr args))
          (derivative-at f (car args))
          (derivative-at (lambda (s) (apply f (tuple-elements s))) (tuple 'up args)))))

  (define ((power-of-D n) f)
    (if (= n 0) f ((power-of-D (- n 1)) (derivative f))))

  (define ((partial i) f)
    (lambda args
      (derivative-at (lambda (y) (apply f (list-set args i y))) (list-ref args i))))

  (define structural
    (hasheq 'D derivative 'partial partial 'power-of-D power-of-D
            'up (lambda xs (tuple 'up xs)) 'down (lambda xs (tuple 'down xs))
            'ref (lambda (s i) (list-ref (tuple-elements s) i))
            'compose (lambda (f g) (lambda (x) (f (g x))))
            '* product
            'square (lift (lambda (x) (multiply x x)))
            'cube (lift (lambda (x) (multiply x (multiply x x))))))

  (arithmetic
   (for/fold ([all structural]) ([name (in-hash-keys operations)] #:unless (eq? name '*))
     (hash-set all name (lift (op name))))
   number
   (lambda (a b)
     (when (close? a b) (discard "a comparison too close to call"))
     (less? a b))))

(define (flip orientation) (if (eq? orientation 'up) 'down 'up))

;; ---------------------------------------------------------------------------
;; Exact numbers, for programs of rational operations

(define bits-limit 30000)

(define rational-differences
  (differences values
               (hasheq '+ + '- - '* * '/ /)
               <
               (lambda (a b) (< (abs (- a b)) (expt 10 -6)))
               (expt 2 -120)
               (lambda (x)
                 (when (> (+ (integer-length (numerator x)) (integer-length (denominator x)))
                          bits-limit)
                   (discard "numbers too long"))
                 x)))

;; ---------------------------------------------------------------------------
;; Bigfloats, of the current precision

(define big-names
  '([+ bf+] [- bf-] [* bf*] [/ bf/] [sqrt bfsqrt] [exp bfexp] [log bflog]
    [sin bfsin] [cos bfcos] [tan bftan] [atan bfatan] [tanh bftanh]))

(define (bigfloat-differences)
  (define bf (big 'bf))
  (define abs (big 'bfabs))
  (define less? (big 'bf<))
  (define subtract (big 'bf-))
  (define limit (bf 10000))
  (define operations
    (for/hasheq ([entry (in-list big-names)]) (values (car entry) (big (cadr entry)))))
  (differences bf
               (hash-set operations 'atan
                         (case-lambda [(y) ((big 'bfatan) y)] [(y x) ((big 'bfatan2) y x)]))
               less?
               (lambda (a b) (less? (abs (subtract a b)) (bf "1e-6")))
               (bf "1e-40")
               (lambda (x)
                 (unless (less? (abs x) limit) (discard "numbers too large"))
                 x)))
