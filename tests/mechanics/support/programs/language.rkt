#lang racket/base
;; A small language for random programs: S-expressions that are also programs of
;; `mechanics`, run here by an interpreter to which the arithmetic is handed in.
;;
;;     e = number | variable
;;       | (lambda (x ...) e) | (e e ...) | (let ([x e]) e) | (if (< e e) e e)
;;       | (for/fold ([x e]) ([_ (in-range n)]) e)
;;       | (ref e n) | (partial n) | (expt D n) | (delay e)
;;       | an operation: + D up box unbox ...
;;
;; The interpreter builds Racket closures, so that what D differentiates is what
;; it would be in the user's program.

(require racket/promise)

(provide run (struct-out arithmetic) (struct-out exn:discard) discard)

;; operations : name -> procedure.  number : number written -> number run on.
;; less? : number number -> boolean.
(struct arithmetic (operations number less?))

;; Raised where a program is no use for a comparison.
(struct exn:discard exn:fail ())
(define (discard why) (raise (exn:discard why (current-continuation-marks))))

(define steps-limit 200000)

;; The value of a closed program.
(define (run program A)
  (define operations (arithmetic-operations A))
  (define steps 0)
  (define (step!)
    (set! steps (add1 steps))
    (when (> steps steps-limit) (discard "too many steps")))
  (define (evaluate e env)
    (step!)
    (cond
      [(number? e) ((arithmetic-number A) e)]
      [(symbol? e) (lookup e env)]
      [else
       (case (car e)
         [(lambda) (closure (cadr e) (caddr e) env)]
         [(let) (define binding (caadr e))
                (evaluate (caddr e) (bind (car binding) (evaluate (cadr binding) env) env))]
         [(if) (define test (cadr e))
               (if ((arithmetic-less? A) (evaluate (cadr test) env) (evaluate (caddr test) env))
                   (evaluate (caddr e) env)
                   (evaluate (cadddr e) env))]
         [(for/fold) (define range (cadar (caddr e)))
                     (iterate (caadr e) (cadr range) (cadddr e) env)]
         [(delay) (delay (evaluate (cadr e) env))]
         [(ref) ((hash-ref operations 'ref) (evaluate (cadr e) env) (index (caddr e)))]
         [(partial) ((hash-ref operations 'partial) (index (cadr e)))]
         [(expt) ((hash-ref operations 'power-of-D) (index (caddr e)))]
         [else (define f (evaluate (car e) env))
               (define args (for/list ([a (in-list (cdr e))]) (evaluate a env)))
               (unless (procedure? f) (discard "no procedure"))
               (apply f args)])]))
  (define (lookup name env)
    (define found (assq name env))
    (cond [found (cdr found)]
          [(assq name containers) => cdr]
          [else (hash-ref operations name
                          (lambda () (discard (format "unbound: ~a" name))))]))
  (define (closure names body env)
    (define (apply-to . args)
      (unless (= (length args) (length names)) (discard "wrong number of arguments"))
      (evaluate body (append (map cons names args) env)))
    (procedure-reduce-arity apply-to (length names)))
  (define (iterate binding n body env)
    (for/fold ([value (evaluate (cadr binding) env)]) ([_ (in-range n)])
      (evaluate body (bind (car binding) value env))))
  (evaluate program '()))

(define (index i) (if (exact-nonnegative-integer? i) i (discard "no index")))

;; Containers are no part of the arithmetic.
(define containers
  (list (cons 'box box) (cons 'unbox unbox) (cons 'list list) (cons 'car car) (cons 'force force)))

(define (bind name value env) (cons (cons name value) env))
