#lang racket/base
;; Every numeric procedure that takes a procedure of the user's, given one that fails: the user's
;; error comes out as it was raised, and soon; and a value of a wrong kind is told in words.
;;
;; Which procedures there are is read off the manual: on the pages about numbers, each entry
;; with an argument that is a procedure has a row here, or stands in the list of those that
;; compute nothing.

(require racket/list
         racket/runtime-path
         racket/stream
         (prefix-in racket: racket/base)
         mechanics
         mechanics/scmutils
         (only-in mechanics/book standard-map)
         mechanics/plot
         "support/checks.rkt")

;; (bad x) gives x at first, or fails, or gives something else.
(struct row (name ask))
(define-syntax-rule (row-of name (bad) question) (row 'name (lambda (bad) question)))

(define (parabola x) (- (* x x) 2))
(define (bowl v) (+ (square (ref v 0)) (square (ref v 1))))

(define (turning s) (up 1 (ref s 2) (- (ref s 1))))
(define (falling s) (up 1 (ref s 2) -1))
(define start (up 0.0 1.0 0.0))
(define (L-oscillator s)
  (- (* 1/2 (square (velocity s))) (* 1/2 (square (coordinate s)))))
(define (H-oscillator s)
  (+ (* 1/2 (square (momentum s))) (* 1/2 (square (coordinate s)))))
(define (twist x y return fail) (return (+ x y) (- y (* 0.6 (sin (+ x y))))))
(define ((twisting bad) x y return fail)
  (twist x y (lambda (x y) (return (bad x) y)) fail))

(define-syntax-rule (rows-of [name (bad) question] ...)
  (list (row-of name (bad) question) ...))

(define functions-of-numbers
  (rows-of
   [definite-integral (bad) (definite-integral (lambda (x) (bad x)) 0.0 1.0)]
   [definite-integral (bad) (definite-integral (lambda (x) (bad (exp (- x)))) 0.0 +inf.0)]
   [definite-integral-with-tolerance
     (bad) (definite-integral-with-tolerance (lambda (x) (bad x)) 0.0 1.0 1e-8)]
   [integral-conditions (bad) (integral-conditions (lambda (x) (bad x)) 'a 'b)]
   [verify-integral (bad) (verify-integral (lambda (x) (bad x)) 'a 'b 0)]
   [find-minimum (bad) (find-minimum (lambda (x) (bad (parabola x))) -1.0 2.0)]
   [minima (bad) (minima (lambda (x) (bad (parabola x))) -1.0 2.0)]
   [find-minimum (bad) (find-minimum (lambda (x) (bad (parabola x))) 1.0)]
   [minimize (bad) (minimize (lambda (x) (bad (parabola x))) -1.0 2.0)]
   [brent-min (bad) (brent-min (lambda (x) (bad (parabola x))) -1.0 2.0)]
   [golden-section-min (bad) (golden-section-min (lambda (x) (bad (parabola x))) -1.0 2.0)]
   [multidimensional-minimize (bad) (multidimensional-minimize (lambda (v) (bad (bowl v)))
                                                               (up 1.0 2.0))]
   [multidimensional-minimize (bad) (multidimensional-minimize
                                     (lambda (v) (bad (abs (ref v 0)))) (up 1.0 2.0))]
   [nelder-mead (bad) (nelder-mead (lambda (v) (bad (bowl v))) (up 1.0 2.0))]
   [find-root (bad) (find-root (lambda (x) (bad (parabola x))) 1.0)]
   [find-root (bad) (find-root (lambda (x) (bad (parabola x))) 0.0 2.0)]
   [find-root (bad) (find-root (lambda (v) (up (bad (ref v 0)) (- (ref v 1) 3))) (up 1.0 2.0))]
   [bisect (bad) (bisect (lambda (x) (bad (parabola x))) 0.0 2.0)]
   [newton-search (bad) (newton-search (lambda (x) (bad (parabola x))) 1.0)]
   [zbrent (bad) (zbrent (lambda (x) (bad (parabola x))) 0.0 2.0)]
   [D-numeric (bad) ((D-numeric (lambda (x) (bad x))) 1.0)]
   [richardson-derivative (bad) ((richardson-derivative (lambda (x) (bad x)) 1e-6) 1.0)]
   [compile-function (bad) ((compile-function (lambda (x) (bad x)) 1.0) (racket-flvector 1.0))]))

(define (racket-flvector x) ((dynamic-require 'racket/flonum 'flvector) x))

(define of-Lagrangians
  (rows-of
   [Lagrangian-action (bad) (Lagrangian-action (lambda (s) (bad (L-oscillator s))) sin 0.0 1.0)]
   [Lagrangian-action (bad) (Lagrangian-action L-oscillator (lambda (t) (bad (sin t))) 0.0 1.0)]
   [parametric-path-action
     (bad) ((parametric-path-action (lambda (s) (bad (L-oscillator s))) 0.0 1.0 1.0 0.0) '(0.5))]
   [find-path (bad) (find-path (lambda (s) (bad (L-oscillator s))) 0.0 1.0 1.0 0.0 2)]
   [find-equilibrium (bad) (find-equilibrium (lambda (s) (bad (L-oscillator s))) 0.3)]
   [equilibria (bad) (equilibria (lambda (s) (bad (L-oscillator s))) (up 't 'x 'v))]
   [normal-modes (bad) (normal-modes (lambda (s) (bad (L-oscillator s))) 0.0)]
   [small-oscillation-frequencies
     (bad) (small-oscillation-frequencies (lambda (s) (bad (L-oscillator s))) 0.0)]
   [action-of-orbit (bad) (action-of-orbit (lambda (s) (bad (H-oscillator s))) start)]
   [frequency-of-orbit (bad) (frequency-of-orbit (lambda (s) (bad (H-oscillator s))) start)]
   [loop-integral (bad) (loop-integral (lambda (x) (up 0 (sin x) (bad (cos x)))) 0.0 (* 2 pi))]))

;; d : the state derivative
(define-syntax-rule (motion-rows (d) [name question] ...)
  (rows-of
   [name (bad) (let ([d (lambda (s) (bad (turning s)))]) question)] ...))

(define (above s) (- (ref s 1) 0.5))
(define measured '((0.5 0.1) (1.0 0.2) (1.5 0.1) (2.0 0.0)))

(define motions
  (append
   (motion-rows (d)
     [state-advancer ((state-advancer (lambda () d)) start 2.0)]
     [state-advancer ((state-advancer (lambda () d)) start 2.0 1e-8 #:method 'Radau-IIA-5)]
     [evolve ((evolve (lambda () d)) start void 0.5 2.0)]
     [free-run-state-advancer ((free-run-state-advancer (lambda () d)) start 2.0)]
     [ode-advancer ((ode-advancer d) start 2.0)]
     [advance-beyond ((advance-beyond (lambda () d)) start 0.1 1e-9 2.0)]
     [evolve-trajectory (evolve-trajectory d start 2.0)]
     [evolve-trajectory (evolve-trajectory d start 2.0 #:method 'Dormand-Prince-853)]
     [evolve-trajectory (evolve-trajectory d start 2.0 #:method 'Radau-IIA-5)]
     [evolve-trajectory (evolve-trajectory d start 2.0 #:method (leapfrog 0.1))]
     [evolve-trajectory (evolve-trajectory d start 2.0 #:method (Gauss-Legendre-4 0.1))]
     [evolve-trajectory (evolve-trajectory d start 1.0 #:precision 80)]
     [linearized-flow ((linearized-flow (lambda () d)) start 2.0)]
     [chaos-indicator (chaos-indicator d start 5.0)]
     [Poincare-map ((Poincare-map d (event above)) start)]
     [stroboscopic-map ((stroboscopic-map d 2.0) start)]
     [find-periodic-orbit (find-periodic-orbit d start 6.3)]
     [continue-periodic-orbit (continue-periodic-orbit (lambda (p) d) start 6.3 0.0 1.0)]
     [continue-equilibrium (continue-equilibrium (lambda (p) d) (up 0.0 0.1 0.0) 0.0 1.0)]
     [Floquet-multipliers (Floquet-multipliers d start :2pi)]
     [Lyapunov-exponents (Lyapunov-exponents d start 5.0)]
     [maximal-Lyapunov-exponent (maximal-Lyapunov-exponent d start 5.0)]
     [evolve-ensemble (evolve-ensemble (lambda () d) (list start start) 1.0)]
     [fit-motion (fit-motion d start measured #:measured above)]
)
   (rows-of
    [fit-motion (bad) (fit-motion turning start measured #:measured (lambda (s) (bad (above s))))]
    [event (bad) (evolve-trajectory turning start 2.0
                                    #:events (event (lambda (s) (bad (above s)))))]
    [Poincare-map (bad) ((Poincare-map turning (event (lambda (s) (bad (above s))))) start)]
    [evolve (bad) ((evolve (lambda () turning)) start (lambda (s) (bad s)) 0.5 2.0)])))

(define-syntax-rule (map-rows (m) [name question] ...)
  (rows-of [name (bad) (let ([m (twisting bad)]) question)] ...))

(define golden (- 1 (/ 1 golden-ratio)))
(define saddle (find-fixed-point twist (up 3.0 0.1)))
(define broken (standard-map 1.1))

(define maps
  (map-rows (m)
    [iterated-map ((iterated-map m 20) 0.1 0.2 list void)]
    [iterated-map ((iterated-map m 20000) 0.1 0.2 list void)]
    [orbit-stream (stream->list (stream-take (orbit-stream m 0.1 0.2) 10))]
    [find-fixed-point (find-fixed-point m (up 0.1 0.1))]
    [periodic-points (periodic-points m 1 (list 0.0 6.0 -1.0 1.0) #:grid '(3 3))]
    [fixed-point-eigen (fixed-point-eigen m :pi 0.0 1e-10 list)]
    [invariant-manifold (invariant-manifold m saddle #:length 1.0)]
    [homoclinic-points (homoclinic-points m saddle #:inverse m #:length 1.0)]
    [radially-mapping-points (radially-mapping-points m -0.5 0.5 0.3 1e-8)]
    [fast-Lyapunov-indicator (fast-Lyapunov-indicator m (up 0.1 0.1) 100)]
    [maximal-Lyapunov-exponent (maximal-Lyapunov-exponent m (up 0.1 0.1) 100)]
    [find-invariant-curve (find-invariant-curve m golden 0.0 2.0 2.8 1e-6)]
    [which-way? (which-way? golden 0.0 2.0 m 1000)]
    [invariant-circle (invariant-circle m golden)]
    [invariant-circle-limit
     (invariant-circle-limit (lambda (k) (if (> k 0.5) broken m)) golden 0.0 1.0 #:tolerance 1.0
                             #:most-modes 128)]
    [rotation-number (rotation-number m (up 0.1 2.0) 100)]))

(define ((falls-to p) s) (up (- p (ref s 0))))
(define resting (continue-equilibrium falls-to (up 0.1) 0 1))

(define pictures
  (append
   (rows-of
    [plot-function (bad) (plot-function (frame 0 1 0 1) (lambda (x) (bad x)) 0.0 1.0)]
    [plot-parametric
      (bad) (plot-parametric (frame 0 1 0 1) (lambda (x) (cons (bad x) x)) 0.0 1.0 0.1)]
    [plot-parametric-fill
      (bad) (plot-parametric-fill (frame 0 1 0 1) (lambda (x) (make-point (bad x) x)) 0.0 1.0
                                  (plane-near? 0.1))]
    [plot-contours (bad) (plot-contours (frame 0 1 0 1) (lambda (x y) (bad x)) '(0.5))]
    [plot-branch (bad) (plot-branch (frame 0 1 0 1) resting (lambda (s) (bad (ref s 0))))]
    [plot-phase-portrait
      (bad) (plot-phase-portrait (frame -1 1 -1 1) (lambda (s) (bad (H-oscillator s))))])
   (map-rows (m)
     [display-map (display-map (frame -3 3 -3 3) m 0.1 0.1 10)]
     [chaos-map (chaos-map (frame -3 3 -3 3 #:width 60 #:height 60) m 10 #:samples 4)])
   (motion-rows (d)
     [chaos-map (chaos-map (frame -3 3 -3 3 #:width 60 #:height 60) d 1.0 #:samples 2
                           #:state (lambda (q p) (up 0 q p)))])))

(define table (append functions-of-numbers of-Lagrangians motions maps pictures))

;; ---------------------------------------------------------------------------
;; All of them

(define-runtime-path reference "../../scribblings/mechanics/reference")
(define numeric-pages
  '("branches" "compiled-functions" "data" "ensembles" "local-tuples" "maps" "motion" "pictures"
    "scmutils"))

;; They make something of the procedure, which is not called, or call it where the user does.
(define no-numbers
  '(Gamma path->state-path make-eta elliptic-integrals Jacobi-elliptic-functions
    ;; these have other names that make what is asked here
    derivative matrix:generate generalized-LE LE Lagrange-equations-operator
    local-state-derivative Lagrange-equations-1 phase-space-derivative
    ;; the map is called in a window; the error is the reason why there is no code
    explore-map default-collector export-system
    ;; called with rows that were read, as the user's loop would call it
    read-table))

(define (manual-page name)
  (call-with-input-file (build-path reference (string-append name ".scrbl"))
    (lambda (port)
      (parameterize ([read-accept-reader #t] [read-accept-lang #t])
        (syntax->datum (read-syntax name port))))))

(define (entries form)
  (cond [(not (and (pair? form) (list? form))) '()]
        [(eq? (first form) 'defproc) (list (second form))]
        [else (append-map entries form)]))

;; ((name [argument contract] ...)) with a contract of procedures
(define (takes-procedure? entry)
  (for/or ([argument (in-list (rest entry))])
    (and (list? argument)
         (for/or ([word (in-list (flatten argument))])
           (memq word '(procedure? -> Lagrangian))))))

(define (entry-name entry)
  (if (pair? (first entry)) (entry-name (first entry)) (first entry)))

(test-case "every entry of the numeric pages that takes a procedure has a row"
  (define wanted
    (for*/list ([page (in-list numeric-pages)]
                [entry (in-list (entries (manual-page page)))]
                #:when (takes-procedure? entry))
      (entry-name entry)))
  (check-true (> (length wanted) 40))
  (check-equal? (remove* (append no-numbers (map row-name table)) wanted) '()))

;; ---------------------------------------------------------------------------
;; Errors

;; Fails from the n-th call on, and counts how often it did.
(struct failing (bad count))
(define (make-failing fail n)
  (define calls 0)
  (define failures 0)
  (failing (lambda (x)
             (set! calls (+ calls 1))
             (cond [(< calls n) x]
                   [else (set! failures (+ failures 1)) (fail)]))
           (lambda () failures)))

(define (outcome thunk)
  (with-handlers ([(lambda (e) (not (exn:break? e))) values])
    (thunk)
    'nothing))

(struct way (name fail own?))
(define ways
  (list (way "error" (lambda () (error 'my-force "spring broke"))
             (lambda (e) (and (exn:fail? e) (equal? (exn-message e) "my-force: spring broke"))))
        (way "raise" (lambda () (raise 'my-thing)) (lambda (e) (eq? e 'my-thing)))
        (way "a slip" (lambda () (racket:car '()))
             (lambda (e) (and (exn:fail? e)
                              (regexp-match? #rx"^car: contract violation" (exn-message e)))))))

(define most-calls 12)

(for* ([r (in-list table)] [w (in-list ways)])
  (test-case (format "~a: ~a" (row-name r) (way-name w))
    (define f (make-failing (way-fail w) 1))
    (define e (outcome (lambda () ((row-ask r) (failing-bad f)))))
    (check-true ((way-own? w) e) (format "~a" (if (exn? e) (exn-message e) e)))
    (check-true (<= ((failing-count f)) most-calls)
                (format "called ~a times" ((failing-count f))))))

;; Later it may be compiled, and not called any more.
(for* ([r (in-list table)] [w (in-list ways)] [n '(3 12)])
  (test-case (format "~a: ~a, at call ~a" (row-name r) (way-name w) n)
    (define f (make-failing (way-fail w) n))
    (define e (outcome (lambda () ((row-ask r) (failing-bad f)))))
    (check-true (or ((way-own? w) e) (eq? e 'nothing))
                (format "~a" (if (exn? e) (exn-message e) e)))))

;; ---------------------------------------------------------------------------
;; Values of a wrong kind

;; Words of the implementation, or of Racket's own procedures
(define internal
  (regexp (string-append "^(fl[^o]|fx|unsafe|vector-|flvector|car:|cdr:|real->|list-|hash-)"
                         "|^(match|apply|#<)"
                         "|^[-+*/<>=]+: contract|^[a-z]*: contract violation")))

(for* ([r (in-list table)] [odd (list "text" 'a-symbol 1+2i +nan.0 (void) #f)])
  (test-case (format "~a: the value ~s is told in words" (row-name r) odd)
    (define e (outcome (lambda () ((row-ask r) (lambda (x) odd)))))
    (check-true (or (not (exn? e)) (exn:fail? e)) (format "~s" e))
    (check-false (and (exn? e) (regexp-match? internal (exn-message e)))
                 (if (exn? e) (exn-message e) ""))))
