#lang racket/base
;; Questions to the library, through its public names, and its answers as plain data.

(require racket/port racket/promise
         (prefix-in m: mechanics)
         (only-in mechanics/error/failure exn:fail:mechanics?)
         (only-in mechanics/value/simplify simplify/assumptions)
         (only-in mechanics/teaching/derivation/canonical-map verify-canonical-map)
         "statement.rkt")

(provide folded as-handed-over asked-zero asked-form asked-solution asked (struct-out answer))

;; status : 'proved, 'refuted, 'undecided, or 'found of a value; assumptions : datums
;; witness : ((S-expression . number) ...) or #f; value : a datum, or #f
(struct answer (status assumptions witness value))

;; ---------------------------------------------------------------------------
;; From an S-expression to a value, as a program would compute it

(define procedures
  (hasheq '+ m:+ '- m:- '* m:* '/ m:/ 'expt m:expt 'sqrt m:sqrt 'square m:square 'cube m:cube
          'exp m:exp 'log m:log 'sin m:sin 'cos m:cos 'tan m:tan 'asin m:asin 'acos m:acos
          'atan m:atan 'sinh m:sinh 'cosh m:cosh 'tanh m:tanh
          'asinh m:asinh 'acosh m:acosh 'atanh m:atanh 'abs m:abs 'sgn m:sgn
          'erf m:erf))

(define (build e)
  (cond [(pair? e)
         (define arguments (map build (cdr e)))
         (apply (build-head (car e) (length arguments)) arguments)]
        [else e]))

(define (build-head head arity)
  (cond [(symbol? head) (hash-ref procedures head (lambda () (literal head arity)))]
        [else ((build-derivative (car head)) (literal (cadr head) arity))]))

(define (literal name arity)
  (if (eqv? arity 1)
      (m:literal-function name)
      (m:literal-function name (m:-> (m:X m:Real m:Real) m:Real))))

(define (build-derivative how)
  (cond [(eq? how 'D) m:D]
        [(eq? (car how) 'partial) (apply m:partial (cdr how))]
        [(eq? (car how) 'expt) (m:expt (build-derivative (cadr how)) (caddr how))]
        [else (apply m:* (map build-derivative (cdr how)))]))

;; A statement as the library gets it: functions of numbers are numbers, as (sqrt 2) is.
(define (folded e)
  (cond [(pair? e)
         (define new (cons (car e) (map folded (cdr e))))
         (define value (if (andmap number? (cdr new)) (build new) new))
         (if (number? value) value new)]
        [else e]))

;; The same after the constructors, which may have cancelled something.
(define (as-handed-over e) (m:expression (build e)))

;; ---------------------------------------------------------------------------
;; Questions.  Each is asked in a thread of its own, so that what is declared there is
;; forgotten with it.

(define (asked-zero left right given)
  (apply m:assume given)
  (verdict->answer (m:prove-zero (m:- (build left) (build right)))))

(define (verdict->answer v)
  (answer (m:verdict-status v)
          (m:verdict-assumptions v)
          (and (m:refuted? v)
               (for/list ([entry (in-list (m:verdict-witness v))])
                 (cons (m:expression (car entry)) (cdr entry))))
          #f))

;; -> an S-expression, and what it assumes
(define (asked-form e given)
  (apply m:assume given)
  (define-values (simple assumptions) (simplify/assumptions (build e)))
  (values (m:expression simple) (append assumptions given)))

;; Does the path, an S-expression in t, solve the equation of motion
;; d²q/dt² = force, an S-expression in q?
(define (asked-solution path force)
  (define (L s)
    (m:- (m:* 1/2 (m:square (m:velocity s))) (potential force (m:coordinate s))))
  (define (q t) (build (substituted path 't t)))
  (verdict->answer (m:verify-solution L q)))

(define (potential force q)
  (case force
    [(none) 0]
    [(constant) q]
    [else (m:* 1/2 (m:square q))]))

;; ---------------------------------------------------------------------------
;; Programs

(define-namespace-anchor here)

(define programs
  (delay
    (let ([n (namespace-anchor->empty-namespace here)])
      (parameterize ([current-namespace n]) (namespace-require 'mechanics))
      (namespace-set-variable-value! 'verify-canonical-map verify-canonical-map #t n)
      n)))

;; The result of a program, without its notes; undecided where it is refused.
(define (asked program)
  (define found
    (parameterize ([current-namespace (force programs)]
                   [current-error-port (open-output-nowhere)])
      (with-handlers ([exn:fail:mechanics? (lambda (e) 'refused)]) (eval program))))
  (cond [(eq? found 'refused) (answer 'undecided '() #f #f)]
        [(m:verdict? found) (verdict->answer found)]
        [else (answer 'found (m:assumptions 'used) #f (datum found))]))

(define (datum found) (if (list? found) (map datum found) (m:expression found)))
