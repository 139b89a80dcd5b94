#lang racket/base
;; The arguments of integrations, checked once, where they enter.

(require racket/flonum
         "../../algebra/expression/expression.rkt"
         "../../algebra/expression/symbols.rkt"
         "../../error/complain.rkt" "../../error/hint.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/function-check.rkt" "../../generic/function.rkt" "../../generic/kind.rkt"
         "../../generic/number-argument.rkt" "../../generic/printed-function.rkt"
         "../../generic/scalar.rkt" "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../lagrangian/function-name-hints.rkt" "../../lagrangian/function-of-momenta.rkt"
         "../../numeric/finite-number.rkt"
         "../../value/shape.rkt")

(provide
 ;; numbers
 check-real check-positive check-tolerance check-longest check-most real-number
 ;; procedures
 checked-monitor check-maker takes-state-only? check-count
 with-tolerance-after
 ;; states and their derivatives
 state-vector check-derivative check-rates check-clock state-derivative-hint)

;; ---------------------------------------------------------------------------
;; Numbers

;; The number that x stands for, or x.
(define (real-number x) (or (known-number x) x))

(define (check-real who what x)
  (define r (real-number x))
  (unless (finite? r)
    (define kind (if (real? r) "finite" "a real number"))
    (complain-of who (format "expected a ~a that is ~a" what kind) x)))

(define (check-positive who what x [hint ""])
  (check-real who what x)
  (unless (positive? (real-number x))
    (complain-of who (format "expected a positive ~a" what) x hint)))

;; The least tolerance that differs from rounding.
(define least-tolerance 1e-15)

;; bits : of numbers of higher precision than flonums, or #f
(define (check-tolerance who x [bits #f])
  (check-positive who "tolerance" x)
  (when (> (real-number x) 1)
    (complain-of who "a tolerance of more than 1 leaves nothing of the state" x
                 "\n  a billionth is 1e-9"))
  (unless (>= (real-number x) (if bits (expt 2 (- 3 bits)) least-tolerance))
    (complain-of who
                 (if bits
                     (format "the tolerance is below the rounding error of ~a bits, about 1e-~a"
                             bits (quotient (* bits 30103) 100000))
                     "the tolerance is below the rounding error of flonums, about 1e-15")
                 x)))

(define (check-longest who x)
  (unless (eqv? x +inf.0) (check-positive who "longest step" x)))

(define (check-most who x)
  (unless (or (eqv? x +inf.0) (exact-positive-integer? x))
    (complain-of who "expected the most steps to take, a positive integer" x)))

(define (complain-of who what x [hint ""])
  (complain who "~a\n  given: ~a~a" what (describe-with-value x)
            (cond [(symbolic? x) symbols-hint]
                  [(list? x) (list-hint x)]
                  [else hint])))

;; ---------------------------------------------------------------------------
;; Procedures

;; -> the monitor.  One that returns a function was given too few arguments, as
;; `monitor-theta` without its frame, and would show nothing of any state.
(define (checked-monitor who f)
  (unless (takes-arguments? f 1)
    (raise-other-function who "a monitor, a procedure of one state" f))
  (define (check-shown . values)
    (for ([v (in-list values)] #:when (pointwise? v))
      (complain who
                "the monitor returns a function; it does nothing with the state\n  monitor: ~a~a"
                (describe-with-value f) (parameters-hint f))))
  (lambda (state) (call-with-values (lambda () (f state)) check-shown)))

(define (parameters-hint f)
  (format "\n  parameters are supplied first: (~a ...)" (value->text f)))

;; maker : it must make a state derivative of that many parameters
(define (check-maker who maker parameters)
  (check-not-residual who maker)
  (check-argument who procedure? maker "a procedure that makes a state derivative")
  (unless (or (accepts? maker (length parameters)) (takes-state-only? maker parameters))
    (complain
     who
     (string-append
      "expected as many parameters as the maker of the state derivative takes"
      "\n  maker: ~a, which takes ~a\n  parameters: ~a~a")
     (describe-with-value maker) (arity->text maker)
     (if (null? parameters) "none" (value->text parameters))
     (if (takes-state-only? maker '())
         "\n  a state derivative itself is given without parameters"
         "")))
  (when (and (pair? parameters) (state-derivative? maker))
    (complain who
              (string-append "it makes a state derivative of the parameters, and this is one "
                             "already\n  given: ~a\n  parameters: ~a\n  what takes them is as "
                             "(lambda (m) (Lagrangian->state-derivative (L m)))")
              (value->text maker) (value->text parameters))))

(define (state-derivative? f)
  (memq (made-by f) '(Lagrangian->state-derivative Hamiltonian->state-derivative)))

;; Refuses Lagrange's equations, which are residuals and no state derivative.
(define (check-not-residual who f)
  (define d (value->datum f))
  (when (eq? 'Lagrange-equations (if (pair? d) (car d) d))
    (complain who "Lagrange-equations gives residuals of a path, not the rates of a state\n  ~a"
              of-Lagrangian)))

(define of-Lagrangian "(Lagrangian->state-derivative L) makes a state derivative of a Lagrangian")
(define of-Hamiltonian
  "(Hamiltonian->state-derivative H) makes a state derivative of a Hamiltonian")

;; Advice where f gives a number for a state, as a Lagrangian or a Hamiltonian does.
(define (state-derivative-hint f [state #f])
  (if (or (of-momenta? f) (called-Hamiltonian? f) (and state (momenta? state)))
      of-Hamiltonian
      of-Lagrangian))

;; Has the state momenta, which are down?
(define (momenta? state)
  (define parts (vector->list (tuple-elements state)))
  (and (= 3 (length parts)) (let ([p (caddr parts)]) (and (tuple? p) (down? p)))))

;; The state derivative itself may stand for the procedure of no parameters that
;; makes it.
(define (takes-state-only? f ps)
  (and (null? ps) (accepts? f 1) (not (accepts? f 0))))

;; (datum) : that of the procedure; arity : its mask; takes : its arguments, in words
(define (check-count arity datum takes arguments)
  (define n (length arguments))
  (unless (bitwise-bit-set? arity n)
    (complain-of-arity (value->text (datum)) "takes ~a\n  given: ~a"
                       takes
                       (cond [(= n 0) "no arguments"]
                             [(= n 1) (describe-with-value (car arguments))]
                             [else (format "~a arguments" n)]))))

;; f by that name; a keyword for the tolerance, as evolve-trajectory has one, is told its place.
(define (with-tolerance-after what who f)
  (define (advice name)
    (and (eq? name '#:tolerance)
         (format "the tolerance is given without one, after the ~a" what)))
  (telling-what-it-takes who f #:advice advice))

;; ---------------------------------------------------------------------------
;; States and their derivatives

(define (state-vector who state)
  (define (fail x) (raise-no-state who state x))
  (define y (structure->flvector state fail))
  (when (eqv? (flvector-length y) 0)
    (complain-showing who "a state without components has no motion" "state" state))
  (for ([x (in-flvector y)])
    (unless (finite? x) (fail x)))
  y)

(define (raise-no-state who state x)
  (when (eq? state x)
    (complain-of-argument
     who "a state, a tuple of real numbers such as (up t q v)" x
     (cond [(symbolic? x) symbols-hint]
           [(procedure? x) "\n  the state derivative comes first, then the state"]
           [else (list-hint x "(up t q v)")])))
  (complain who "expected a state of real numbers; ~a is none\n  state: ~a~a"
            (describe-with-value x) (value->text state)
            (if (symbolic? x) symbols-hint (list-hint x))))

;; -> the value of the derivative at the state
(define (check-derivative who derivative state)
  (define y (state-vector who state))
  (check-not-residual who derivative)
  (unless (takes-arguments? derivative 1)
    (complain who "expected a state derivative, a function of the state\n  given: ~a~a"
              (describe-function derivative)
              (if (pointwise? derivative)
                  (parameters-hint derivative)
                  (quoted-name-hint derivative))))
  (define slope (derivative (flvector->structure state y)))
  (check-rates who derivative state slope)
  (for ([x (in-list (scalars slope))])
    (unless (number? (real-number x)) (raise-no-derivative who slope x)))
  slope)

;; slope : the value of the derivative at the state, which must have the state's shape
(define (check-rates who derivative state slope)
  (unless (same-shape? slope state)
    (complain who "the state derivative is of another shape than the state~a~a~a"
              (field "state" state) (field "derivative" slope)
              (cond [(and (tuple? state) (scalar? slope))
                     (string-append "\n  " (state-derivative-hint derivative state))]
                    [(list? slope) (list-hint slope)]
                    [(pointwise? slope) (parameters-hint derivative)]
                    [else ""]))))

(define (raise-no-derivative who slope x)
  (define symbols (if (symbolic? x) (symbols-in x) '()))
  (cond [(pair? symbols)
         (complain who "the symbol ~a is left in the state derivative~a\n  ~a"
                   (car symbols) (field "state derivative" slope)
                   "give it as a parameter, or substitute a number for it")]
        [else
         (complain who "the state derivative holds ~a; expected real numbers~a"
                   (describe-with-value x) (field "state derivative" slope))]))

(define (field label x) (format "\n  ~a: ~a" label (value->text x)))

(define (check-clock who state clock?)
  (unless clock?
    (complain-of who "the first component of the state is not the time: its derivative is not 1"
                 state)))
