#lang racket/base
;; The phase portrait of a system of one degree of freedom (SICM 3.3, p. 223): its orbits are the
;; curves on which the energy is constant.
;;
;; Where both derivatives of the energy vanish the system rests.  Through the saddles among these
;; places go the separatrices, drawn at exactly their energies.  The other orbits are at
;; energies that part the frame into strips of equal areas.

(require racket/flonum
         (only-in racket/list remove-duplicates)
         racket/vector
         "contour.rkt" "frame.rkt" "style.rkt"
         (only-in "../../algebra/expression/expression.rkt" symbolic?)
         "../../calculus/derivative.rkt"
         (only-in "../../compile/compile-function.rkt" compile-function compiled-function-runner)
         "../../error/complain.rkt" "../../error/failure.rkt" "../../error/hint.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         (only-in "../../lagrangian/function-name-hints.rkt" called-Lagrangian?)
         "../../numeric/finite-number.rkt" "../../numeric/optimization/newton.rkt"
         (only-in "../../value/structure.rkt" ref))

(provide plot-phase-portrait
         ;; for tests
         places-of-rest (struct-out place))

;; energy : of a state (up t q p) -> number
(define (plot-phase-portrait f energy #:orbits [orbits 12] #:samples [samples 201]
                             #:color [color 'gray] #:separatrix-color [separatrix-color 'red])
  (define who 'plot-phase-portrait)
  (check-plain who f)
  (check-energy-function who energy)
  (unless (and (exact-nonnegative-integer? orbits) (<= orbits 500))
    (complain-of-argument who "how many orbits, from 0 to 500" orbits))
  (define bounds (frame-bounds f))
  (define h (energy-on-plane who energy bounds))
  (define resting (places-of-rest who energy bounds))
  (define saddles (filter saddle? resting))
  (plot-contours f h (levels-between h bounds orbits) #:samples samples #:color color)
  (plot-contours f h (distinct-energies saddles) #:samples samples
                 #:color separatrix-color #:width 2)
  (for ([r (in-list resting)])
    (define color (if (saddle? r) separatrix-color 'black))
    (add-dot! who f (make-style who 'points color 5 'solid #f) (place-q r) (place-p r)))
  f)

(define (check-energy-function who energy)
  (unless (and (procedure? energy) (accepts? energy 1))
    (complain who (string-append expected-energy "\n  given: ~a~a")
              (describe-function energy)
              (if (pointwise? energy)
                  (format "\n  parameters are supplied first: (~a ...)" (value->text energy))
                  (quoted-name-hint energy))))
  (when (called-Lagrangian? energy)
    (complain who
              (string-append "orbits are curves of constant energy, which a Lagrangian is not"
                             "\n  given: ~a"
                             "\n  over momenta: (plot-phase-portrait f (Lagrangian->Hamiltonian L))"
                             "\n  over velocities: (plot-phase-portrait f (Lagrangian->energy L))")
              (value->text energy))))

(define expected-energy
  (string-append "expected the energy of a system of one degree of freedom, a function of a state "
                 "(up t q p)"))

;; -> (q p -> energy), compiled
(define (energy-on-plane who energy bounds)
  (define middle (middle-of bounds))
  (check-energy who ((at-time energy 0) middle) ((at-time energy 0.7) middle))
  (define run! (compiled-function-runner (compile-function (at-time energy 0) middle #:name who)))
  (define-values (from to) (values (make-flvector 2) (make-flvector 1)))
  (lambda (q p)
    (flvector-set! from 0 q)
    (flvector-set! from 1 p)
    (run! from to)
    (flvector-ref to 0)))

;; The energy as a function of the point (up q p), at a time.
(define ((at-time energy t) v) (energy (up t (ref v 0) (ref v 1))))

(define (middle-of bounds)
  (define-values (q-min q-max p-min p-max) (apply values bounds))
  (up (+ q-min (* 0.51 (- q-max q-min))) (+ p-min (* 0.52 (- p-max p-min)))))

(define (check-energy who now later)
  (unless (real? now)
    (complain who (string-append expected-energy "\n  its value: ~a~a")
              (describe-with-value now)
              (if (symbolic? now) symbols-hint "")))
  (unless (< (abs (- now later)) (* 1e-9 (+ 1.0 (abs now))))
    (complain who
              (string-append "the energy depends on the time, so that orbits cross in this plane"
                             "\n  a stroboscopic-map shows them once in each period"))))

;; ---------------------------------------------------------------------------
;; Places of rest

;; kind : 'saddle, 'centre or 'degenerate
(struct place (q p energy kind) #:transparent)

(define (saddle? r) (eq? (place-kind r) 'saddle))

(define starts 15)               ; of Newton's method, to a side
(define most-steps 30)

(define (places-of-rest who energy bounds)
  (define h (energy-on-plane who energy bounds))
  (define slopes! (slopes-runner who energy bounds))
  (define-values (q-min q-max p-min p-max) (apply values bounds))
  (define near (* 1e-6 (max (- q-max q-min) (- p-max p-min))))
  (for*/fold ([found '()] #:result (reverse found))
             ([q (in-list (nodes q-min q-max starts))]
              [p (in-list (nodes p-min p-max starts))])
    (define r (rest-near slopes! h q p))
    (if (and r (<= q-min (place-q r) q-max) (<= p-min (place-p r) p-max)
             (not (for/or ([s (in-list found)]) (same-place? r s near))))
        (cons r found)
        found)))

(define (same-place? r s near)
  (and (< (abs (- (place-q r) (place-q s))) near) (< (abs (- (place-p r) (place-p s))) near)))

;; -> (from to -> void): both derivatives of the energy, then the four second ones
(define (slopes-runner who energy bounds)
  (define (slope v) (derivative-at (at-time energy 0) v))
  (compiled-function-runner
   (compile-function (lambda (v) (up (slope v) (derivative-at slope v))) (middle-of bounds)
                     #:name who)))

;; -> the place of rest that Newton's method finds from (q, p), or #f
(define (rest-near slopes! h q p)
  (define s (make-flvector 6))
  (define (slopes at)
    (slopes! at s)
    (flvector (flvector-ref s 0) (flvector-ref s 1)))
  (define (second-slopes at)
    (slopes! at s)
    (vector (vector (flvector-ref s 2) (flvector-ref s 3))
            (vector (flvector-ref s 4) (flvector-ref s 5))))
  (with-handlers ([exn:fail:mechanics? (lambda (e) #f)])
    (define-values (found step) (newton slopes second-slopes (flvector q p) #:limit most-steps))
    (define-values (x y) (values (flvector-ref found 0) (flvector-ref found 1)))
    (place x y (h x y) (kind-by (second-slopes found)))))

;; rows : of second derivatives
(define (kind-by rows)
  (define (entry i j) (vector-ref (vector-ref rows i) j))
  (define determinant (- (* (entry 0 0) (entry 1 1)) (* (entry 0 1) (entry 1 0))))
  (cond [(< determinant 0.0) 'saddle]
        [(> determinant 0.0) 'centre]
        [else 'degenerate]))

;; ---------------------------------------------------------------------------
;; Energies

;; -> n energies that divide the frame into n + 1 strips of equal areas
(define (levels-between h bounds n)
  (define-values (q-min q-max p-min p-max) (apply values bounds))
  (define energies
    (for*/vector ([q (in-list (nodes q-min q-max 60))] [p (in-list (nodes p-min p-max 60))]
                  [energy (in-value (h q p))]
                  #:when (finite? energy))
      energy))
  (vector-sort! energies <)
  (define count (vector-length energies))
  (if (= count 0)
      '()
      (for/list ([k (in-range 1 (+ n 1))])
        (vector-ref energies (quotient (* k (- count 1)) (+ n 1))))))

;; Saddles of one energy, as those of a pendulum are, have the same separatrices.
(define (distinct-energies saddles)
  (remove-duplicates (sort (map place-energy saddles) <)
                     (lambda (a b) (< (abs (- a b)) (* 1e-9 (+ 1.0 (abs a)))))))
