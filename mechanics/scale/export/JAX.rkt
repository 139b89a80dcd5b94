#lang racket/base
;; A system as a module of Python for JAX: its rates, and integrators that `jit`, `vmap` and
;; `grad` go through, in 64 bits.

(require racket/list
         racket/runtime-path
         racket/string
         "exported-system.rkt" "method-text.rkt" "program-text.rkt" "python.rkt" "template.rkt"
         "variable-names.rkt"
         (only-in "../../numeric/ode/dormand-prince-54.rkt" dormand-prince-54-formulas)
         "../../operation/operation-column.rkt")

(provide JAX-files)

(define-runtime-path JAX-folder "JAX")

;; -> alist of names of files and their texts
(define (JAX-files who s)
  (define-values (stages estimate) (method-tableau dormand-prince-54-formulas))
  (define words
    (hash-set* (python-words s)
               "SIZE" (number->string (exported-size s))
               "STAGES" (parenthesized (map parenthesized stages) ",\n      ")
               "ERROR" (parenthesized estimate)
               "BODY" (python-body who s)))
  (list (cons (string-append (exported-name s) ".py")
              (fill-template (build-path JAX-folder "module.py") words))))

(define (python-body who s)
  (define variables (exported-variables s))
  (define names (identifiers (append variables (exported-parameters s)) reserved))
  (define-values (lines outputs)
    (program->code (exported-slope s) python names (no-function who s "JAX")))
  (define n (length variables))
  (define result (format "return jnp.stack([~a])" (string-join (map as-array outputs) ", ")))
  (indented (append (unpacked "y" (take names n)) (unpacked "p" (drop names n)) lines
                    (list result))))

;; A tuple of Python.
(define (parenthesized texts [between ", "]) (format "(~a,)" (string-join texts between)))

(define (unpacked from names)
  (for/list ([name (in-list names)] [k (in-naturals)]) (format "~a = ~a[~a]" name from k)))

;; A number alone is none of the array's.
(define (as-array text) (format "jnp.asarray(~a, jnp.float64)" text))

(define-column names-in-JAX
  [sqrt "jnp.sqrt"] [exp "jnp.exp"] [log "jnp.log"] [expt "jnp.power"] [abs "jnp.abs"]
  [sgn "jnp.sign"] [erf "jax.scipy.special.erf"]
  [sin "jnp.sin"] [cos "jnp.cos"] [tan "jnp.tan"]
  [asin "jnp.arcsin"] [acos "jnp.arccos"] [atan "jnp.arctan"] [atan2 "jnp.arctan2"]
  [sinh "jnp.sinh"] [cosh "jnp.cosh"] [tanh "jnp.tanh"]
  [asinh "jnp.arcsinh"] [acosh "jnp.arccosh"] [atanh "jnp.arctanh"])

(define python
  (language
   (hash-set names-in-JAX 'wrapped "_wrapped")
   (lambda (name rows right symmetric?)
     (list (format "~a = jnp.linalg.solve(jnp.array([~a]), jnp.array([~a]))" name
                   (string-join (for/list ([row (in-list rows)])
                                  (format "[~a]" (string-join row ", ")))
                                ", ")
                   (string-join right ", "))))
   (lambda (name k) (format "~a[~a]" name k))
   (lambda (name text) (format "~a = ~a" name text))))

(define reserved
  (append python-keywords
          '("y" "p" "jax" "jnp" "jnp_" "lax" "derivative" "evolve" "partial" "INFINITY" "NAN")))
