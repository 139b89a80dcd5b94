#lang racket/base
;; Random programs, well typed.
;;
;; Types: num, (fun (type ...) type), (up type ...), (down type ...) and the
;; containers (box type), (list type), (promise type), which the arithmetic knows
;; nothing of and through which functions and numbers travel.  Derivatives are
;; generated wherever their type is asked for: by numbers, tuples and several
;; arguments, of numbers, tuples and functions.

(provide random-program)

;; A program that takes a number to a number.  elementary? : may it use functions
;; that are not rational?
(define (random-program size elementary?)
  (define e (generate 'num (list (cons 'x 'num)) size elementary?))
  (list 'lambda '(x) e))

;; env : ((name . type) ...)
(define (generate type env size elementary?)
  (define (sub type [env env] [divisor 2])
    (generate type env (quotient (- size 1) divisor) elementary?))
  (define (variables type)
    (for/list ([b (in-list env)] #:when (equal? (cdr b) type)) (car b)))

  (define (generate-number)
    (if (<= size 1)
        (number-leaf)
        ((choose number-leaf
                 arithmetic arithmetic arithmetic arithmetic arithmetic
                 elementary elementary elementary
                 use use use use use use use use
                 application
                 component transform transform
                 derivative-of-function derivative-of-function
                 binding binding binding branch loop contained))))

  ;; Leaves too are seldom linear, so that what is confused shows.
  (define (number-leaf)
    (case (random 6)
      [(0 1) (number-variable)]
      [(2 3) (list '* (number-variable) (number-variable))]
      [(4) (if elementary?
               (list (choose 'sin 'cos) (number-variable))
               (list 'square (number-variable)))]
      [else (define functions (variables (fun '(num) 'num)))
            (if (pair? functions)
                (list (pick-early functions) (number-variable))
                (number-variable))]))

  (define (number-variable)
    (define names (variables 'num))
    (if (and (pair? names) (< (random) 0.9))
        (pick-early names)
        (random-constant)))

  ;; A variable in scope that leads to a value of the type: applied, taken apart,
  ;; opened.
  (define (use)
    (define usable
      (for*/list ([b (in-list env)]
                  [expression (in-value (usage (car b) (cdr b)))]
                  #:when expression)
        expression))
    (if (null? usable) (application) ((pick-early usable))))

  ;; -> a maker of such an expression, or #f.
  (define (usage name t)
    (cond [(eq? t 'num) #f]
          [(and (eq? (car t) 'fun) (equal? (caddr t) type))
           (lambda ()
             (define f (if (and (equal? (cadr t) '(num)) (differentiable? t) (= (random 3) 0))
                           (list 'D name)
                           name))
             (cons f (for/list ([d (in-list (cadr t))]) (sub d env (length (cadr t))))))]
          [(and (memq (car t) '(up down)) (member type (cdr t)))
           (lambda () (list 'ref name (if (equal? type (cadr t)) 0 1)))]
          [(and (memq (car t) '(box list promise)) (equal? type (cadr t)))
           (lambda () (list (opener t) name))]
          [else #f]))

  (define (arithmetic)
    (case (random 6)
      [(0 1) (list '+ (sub 'num) (sub 'num))]
      [(2) (list '- (sub 'num) (sub 'num))]
      [(3 4) (list '* (sub 'num) (sub 'num))]
      [else (list '/ (sub 'num) (list '+ 2 (list 'square (sub 'num env 3))))]))

  (define (elementary)
    (if elementary?
        (case (random 5)
          [(0) (list 'exp (list 'sin (sub 'num env 1)))]
          [(1) (list 'sqrt (list '+ 1 (list 'square (sub 'num env 1))))]
          [(2) (list 'log (list '+ 2 (list 'cos (sub 'num env 1))))]
          [(3) (list 'atan (sub 'num) (list '+ 2 (list 'sin (sub 'num))))]
          [else (list (choose 'sin 'cos 'atan 'tanh) (sub 'num env 1))])
        (list (choose 'square 'cube) (sub 'num env 1))))

  (define (binding)
    (define name (fresh-name))
    (define bound (random-type 3))
    (list 'let (list (list name (sub bound))) (sub type (extend name bound))))

  (define (branch)
    (list 'if (list '< (sub 'num env 3) (random-constant)) (sub type) (sub type)))

  (define (loop)
    (define name (fresh-name))
    (list 'for/fold (list (list name (sub type)))
          (list (list '_ (list 'in-range (+ 1 (random 3)))))
          (sub type (extend name type))))

  ;; The derivative of a function whose value takes functions, and a program that
  ;; may use it more than once, on functions made with its help (Manzyuk et al.)
  (define (transform)
    (define-values (u f y name) (values (fresh-name) (fresh-name) (fresh-name) (fresh-name)))
    (define container (choose #f #f #f 'box 'list 'promise))
    (define argument (if container (list container (fun '(num) 'num)) (fun '(num) 'num)))
    (define applied (if container (list (opener argument) f) f))
    (define curried? (= (random 2) 0))
    (define point (choose u (list '+ y u) (list '* y u) (list '* u u) y))
    (define body
      (choose (list applied point)
              (list '* u (list applied point))
              (list (list 'D applied) point)
              (list '* (list applied y) (list applied u))))
    (define made
      (if curried?
          (list 'lambda (list u) (list 'lambda (list f) (list 'lambda (list y) body)))
          (list 'lambda (list u)
                (list 'lambda (list f) (list 'let (list (list y (list '* u u))) body)))))
    (define t (fun (list argument) (if curried? (fun '(num) 'num) 'num)))
    (define (wrap e)
      (if container (list (case container [(box) 'box] [(list) 'list] [else 'delay]) e) e))
    ;; A function that comes of applying the transformation n times, each time to
    ;; what comes of applying it once less.
    (define (nested n env)
      (define z (fresh-name))
      (define inner-env (cons (cons z 'num) env))
      (cond [(= n 0) (generate (fun '(num) 'num) env 6 elementary?)]
            [(and curried? (= (random 2) 0)) (list name (wrap (nested (- n 1) env)))]
            [else
             (define inside (list name (wrap (nested (- n 1) inner-env))))
             (list 'lambda (list z) (list '* z (if curried? (list inside z) inside)))]))
    (list 'let (list (list name (list (list 'D made) (sub 'num env 4))))
          (if (eq? type 'num)
              (list '+ (list (nested (+ 1 (random 2)) env) (number-leaf))
                    (generate type (extend name t) (quotient size 2) elementary?))
              (generate type (extend name t) (- size 4) elementary?))))

  ;; A function applied; what it takes is arbitrary.
  (define (application)
    (define domain (for/list ([_ (in-range (choose 1 1 1 2))]) (random-type (choose 0 1 1 2))))
    (cons (sub (fun domain type)) (for/list ([d (in-list domain)]) (sub d env 2))))

  ;; A component of a tuple
  (define (component)
    (define orientation (choose 'up 'down))
    (define i (random 2))
    (define other (random-type 1))
    (list 'ref (sub (list* orientation (if (= i 0) (list type other) (list other type)))) i))

  ;; In a container and out again
  (define (contained)
    (define t (list (choose 'box 'list 'promise) type))
    (list (opener t) (sub t env 1)))
  (define (opener container)
    (case (car container) [(box) 'unbox] [(list) 'car] [else 'force]))

  ;; ((D f) a) of this type, f a function of a number
  (define (derivative-of-function)
    (if (differentiable? type)
        (list (list (choose 'D 'D (list 'expt 'D (+ 1 (random 3)))) (sub (fun '(num) type)))
              (sub 'num env 3))
        (application)))

  ;; A tuple as the derivative by a tuple, or by several arguments
  (define (derivative-by-tuple)
    (define flipped (if (eq? (car type) 'up) 'down 'up))
    (define s (cons flipped (cdr type)))
    (if (and (eq? flipped 'up) (= (random 2) 0))
        (list* (list 'D (sub (fun (cdr type) 'num))) (for/list ([t (cdr type)]) (sub t env 3)))
        (list (list 'D (sub (fun (list s) 'num))) (sub s env 3))))

  (define (generate-tuple)
    (define scalars? (andmap (lambda (t) (eq? t 'num)) (cdr type)))
    (cond
      [(<= size 1) (leaf-or make-tuple)]
      [scalars?
       ((choose (lambda () (leaf-or make-tuple)) make-tuple make-tuple application
                use use derivative-by-tuple derivative-by-tuple derivative-of-function
                (lambda () (list '+ (sub type) (sub type)))
                (lambda () (list '* (sub 'num) (sub type)))
                binding branch loop))]
      [else ((choose (lambda () (leaf-or make-tuple)) make-tuple make-tuple application
                     derivative-of-function binding branch))]))

  (define (make-tuple)
    (cons (car type) (for/list ([t (in-list (cdr type))]) (sub t))))

  (define (generate-function)
    (define domain (cadr type))
    (define range (caddr type))
    (cond
      [(<= size 1) (leaf-or make-function)]
      [else
       ((apply choose
               (append
                (list (lambda () (leaf-or make-function)) make-function make-function make-function
                      use use use use transform application
                      derivative-of-function derivative-of-function
                      binding branch component contained)
                (if (and (equal? domain '(num)) (differentiable? range))
                    (list (lambda () (list 'D (sub type env 1)))
                          (lambda () (list (list 'expt 'D (random 4)) (sub type env 1))))
                    '())
                (if (and (equal? domain '(num num)))
                    (list (lambda () (list (list 'partial (random 2)) (sub type env 1))))
                    '())
                (if (eq? range 'num)
                    (list (lambda () (list (choose '+ '*) (sub type) (sub type)))
                          (lambda () (list '* (sub 'num) (sub type))))
                    '())
                (if (equal? type '(fun (num) num))
                    (list (lambda () (list 'compose (sub type) (sub type))))
                    '()))))]))

  (define (make-function)
    (define names (for/list ([_ (cadr type)]) (fresh-name)))
    (list 'lambda names
          (generate (caddr type) (append (map cons names (cadr type)) env)
                    (- size 1) elementary?)))

  (define (generate-container)
    (define inside (cadr type))
    (leaf-or (lambda ()
               (list (case (car type) [(box) 'box] [(list) 'list] [else 'delay])
                     (sub inside env 1)))))

  (define (leaf-or make)
    (define names (variables type))
    (if (and (pair? names) (< (random) 0.6)) (pick-early names) (make)))

  (define (extend name type) (cons (cons name type) env))

  (cond [(eq? type 'num) (generate-number)]
        [(eq? (car type) 'fun) (generate-function)]
        [(memq (car type) '(up down)) (generate-tuple)]
        [else (generate-container)]))

;; ---------------------------------------------------------------------------
;; Types

(define (fun domain range) (list 'fun domain range))

(define (random-type depth)
  (define (inner) (random-type (- depth 1)))
  (if (= depth 0)
      'num
      (case (random 12)
        [(0 1) 'num]
        [(2 3) (fun '(num) 'num)]
        [(4) (list (choose 'up 'down) 'num 'num)]
        [(5 6) (fun (list (inner)) (inner))]
        [(7) (choose (fun '(num num) 'num) (list 'up (inner) 'num))]
        [(8) (fun (list (fun '(num) 'num)) 'num)]
        [(9) (fun (list (fun '(num) 'num)) (fun '(num) 'num))]
        [(10) (fun (list (list (choose 'box 'list 'promise) (fun '(num) 'num)))
                   (choose 'num (fun '(num) 'num)))]
        [else (list (choose 'box 'list 'promise) (inner))])))

;; Is it a type of values that D returns?
(define (differentiable? type)
  (cond [(eq? type 'num) #t]
        [(eq? (car type) 'fun) (differentiable? (caddr type))]
        [else (and (memq (car type) '(up down)) (andmap differentiable? (cdr type)))]))

;; ---------------------------------------------------------------------------
;; Choices

(define (choose . xs) (list-ref xs (random (length xs))))
(define (pick xs) (list-ref xs (random (length xs))))
;; The first ones, bound last, are likelier.
(define (pick-early xs)
  (if (or (null? (cdr xs)) (< (random) 0.4)) (car xs) (pick-early (cdr xs))))
(define (random-constant) (/ (- (random 13) 6) (+ 1 (random 4))))

(define counter 0)
(define (fresh-name)
  (set! counter (add1 counter))
  (string->symbol (format "v~a" counter)))
