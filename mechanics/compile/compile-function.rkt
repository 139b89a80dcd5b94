#lang racket/base
;; Generic functions compiled to flonum code.
;;
;; A function of a structure becomes one from flvector to flvector: the scalars
;; of its argument in a row, and those of its value.  A function that cannot be traced
;; (trace.rkt) is evaluated by the generic arithmetic instead, at each call:
;; slower, and the same in all else: a complex value is not a number there too.

(require racket/flonum
         "cache.rkt" "code-check.rkt" "closures.rkt" "program.rkt" "derivative-sweep.rkt"
         "shorter-program.rkt" "trace.rkt"
         "../calculus/gradient.rkt"
         "../error/complain.rkt" "../error/failure.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function-check.rkt" "../generic/function.rkt" "../generic/up-down.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../numeric/flvector.rkt"
         "../value/shape.rkt")

(provide
 compile-function compile-scalar
 compiled-function? compiled-function-reason compiled-function-operations
 ;; for the integrators
 compile-traced traced-program traced-gradient program->compiled-function
 check-function
 compiled-function-runner compiled-function-value-shape compiled-function-inputs
 compiled-function-outputs compiled-function-program)

;; make-runner : -> (input output -> void), between flvectors
;; inputs, outputs : how many scalars; value-shape : a structure of that many
;; operations : how many flonum operations a call takes, or #f
;; program : the one compiled; reason : why there is none, or #f
(value-struct compiled-function
  (make-runner inputs outputs value-shape operations program reason datum)
  #:datum (lambda (c) `(compile-function ,(compiled-function-datum c)))
  #:property prop:procedure (lambda (c input) (apply-to-flvector c input))
  #:property prop:object-name
  (lambda (c) (let ([d (compiled-function-datum c)]) (if (symbol? d) d 'compiled-function))))

;; A new procedure (input output -> void), for one thread at a time and as many runs as
;; wanted: it has its room to work in, which a run does not have to make.
(define (compiled-function-runner c) ((compiled-function-make-runner c)))

;; value : that of f at the example, if known
;; gradient? : is it to give, after its value, its derivatives by the scalars of its argument?
(define-plain (compile-function f example #:name [who 'compile-function] #:value [value #f]
                                #:gradient? [gradient? #f])
  (check-function who f)
  (cond [gradient? (compile-with-gradient who f example)]
        [else
         (define-values (code reason)
           (code-or-reason who f example (on-flvector f example) (shape-length example) value))
         (or code (evaluate-generically who f example reason))]))

;; One sweep back over the operations of f gives all its derivatives; where that is not possible
;; they are taken of f itself.
(define (compile-with-gradient who f example)
  (check-one-number who f (flvector->structure example (example->flvector who example)))
  (define-values (p shape) (trace who f example))
  (define q (and (program? p) (program-with-gradient p)))
  (define code (and q (gradient-code (shorter-program q) f)))
  (cond [(and code (all-right? who code (with-gradient f) example)) code]
        [(program? p) (compile-function (with-gradient f) example #:name who)]
        [else (evaluate-generically who (with-gradient f) example p)]))

(define (gradient-code q f [make-runner (compiled-program q)])
  (define outputs (vector-length (program-outputs q)))
  (program->compiled-function q (apply up (build-list outputs (lambda (k) 0))) f make-runner))

(define ((with-gradient f) x) (up (f x) ((gradient f) x)))

;; Is the code that of f, whatever its argument?
(define (all-right? who code f example)
  (right? code (on-flvector f example) (example->flvector who example) (shape-length example) #f))

(define ((on-flvector f example) v) (f (flvector->structure example v)))

(define (check-one-number who f x)
  (define y (f x))
  (unless (= 1 (shape-length y))
    (complain who "a gradient is that of a function whose value is one number\n  value: ~a"
              (describe-with-value y))))

;; The same for a function that can be traced; of others, and where symbols are left, #f.
;; The code is used only where the scalars of the argument after the first `varying` are
;; those of the example; value-at : flvector -> the value there
(define (compile-traced f example #:name who
                        #:value-at [value-at (on-flvector f example)]
                        #:varying [varying (shape-length example)]
                        #:value [value #f])
  (check-function who f)
  (define-values (code reason)
    (code-or-reason who f example value-at varying value #:unknown void))
  code)

(define (code-or-reason who f example value-at varying value
                        #:unknown [check-unknown raise-no-value])
  (define point (example->flvector who example))
  (define-values (p shape) (trace who f example #:unknown check-unknown))
  (define code (and (program? p) (program->compiled-function (shorter-program p) shape f)))
  (cond [(not code) (values #f p)]
        [(right? code value-at point varying value) (values code #f)]
        [else (values #f different)]))

;; f as a function from flonum to flonum, or #f; `example` is an argument to try it on.
;; Not for two threads at once: argument and value pass through vectors of its own.
(define (compile-scalar f example)
  (define code (compile-traced f example #:name 'compile-scalar))
  (and code
       (= 1 (compiled-function-outputs code))
       (let ([run (compiled-function-runner code)]
             [input (make-flvector 1)]
             [output (make-flvector 1)])
         (lambda (x)
           (flvector-set! input 0 x)
           (run input output)
           (flvector-ref output 0)))))

;; The program of a function that can be traced, checked by running it, and not compiled; or #f.
(define (traced-program f example #:name who)
  (define-values (p shape) (trace who f example #:unknown void))
  (and (program? p)
       (all-right? who (program->compiled-function p shape f (program->closure-maker p)) f example)
       p))

;; The same of the value and the derivatives of a function whose value is one number.
(define (traced-gradient f example #:name who)
  (define-values (p shape) (trace who f example #:unknown void))
  (define q (and (program? p) (= 1 (shape-length shape)) (program-with-gradient p)))
  (and q
       (all-right? who (gradient-code q f (program->closure-maker q)) (with-gradient f) example)
       q))

(define different "its value differs from that of its trace: it tells symbols from numbers")

(define (example->flvector who example)
  (structure->flvector example (lambda (x) (raise-not-a-number who "example" x))))

;; shape : of its value; f : the function of which p is the program
(define (program->compiled-function p shape f [make-runner (compiled-program p)])
  (compiled-function make-runner
                     (program-inputs p) (shape-length shape) shape
                     (program-length p) p #f (value->datum f)))

;; f takes one structure.
(define (check-function who f [expected "a function of one structure"])
  (unless (takes-arguments? f 1)
    (complain-of-argument who expected f
                          (if (procedure? f)
                              (format ", which takes ~a\n  parameters are supplied first: (~a ...)"
                                      (arity->text f) (value->text f))
                              ""))))

(define (apply-to-flvector c input)
  (unless (flvector? input)
    (complain (format "(compile-function ~a)" (value->text (compiled-function-datum c)))
              "takes an flvector, such as (flvector ~a)\n  given: ~a"
              (if (= 1 (compiled-function-inputs c)) "1.0" "1.0 2.0 ...")
              (describe-with-value input)))
  (unless (= (flvector-length input) (compiled-function-inputs c))
    (complain-showing (object-name c) "the flvector is of another length than the example"
                      "expected" (compiled-function-inputs c)
                      "given" (flvector-length input)))
  (define output (make-flvector (compiled-function-outputs c)))
  ((compiled-function-runner c) input output)
  output)

;; ---------------------------------------------------------------------------
;; Where the trace stopped

(define (evaluate-generically who f example reason)
  (define numbers (example->flvector who example))
  (define shape (f (flvector->structure example numbers)))
  (define (fail x) (raise-not-a-number who "value" x))
  (define outputs (flvector-length (structure->flvector shape fail)))
  (define (run input output)
    (define value (value-or-nan f (flvector->structure example input) shape))
    (define v (structure->flvector value (lambda (x) (if (number? x) +nan.0 (fail x)))))
    (unless (= (flvector-length v) outputs)
      (complain-showing who "the function's value has changed its shape"
                        "at the example" shape "now" value))
    (flvector-copy! output v))
  (compiled-function (lambda () run)
                     (flvector-length numbers) outputs shape #f #f reason (value->datum f)))

;; As compiled code does, where a matrix has no inverse or an exact zero divides.
(define (value-or-nan f x shape)
  (define (nan e) (scalars->structure shape (lambda (k) +nan.0)))
  (with-handlers ([no-value? nan]) (f x)))

(define (raise-not-a-number who what x)
  (complain who "the ~a holds ~a; expected real numbers" what (describe-with-value x)))
