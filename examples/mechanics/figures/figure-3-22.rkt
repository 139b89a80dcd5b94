#lang mechanics
;; A section of the motion of a top with three moments  (SICM 3.6.5, Figure 3.22)
;;
;; Energy and p_φ are those of the top upright at 30 radians a second, where it cannot sleep.  The
;; section is ψ = 0 with ψ growing, which is the larger of the two p_ψ that the energy allows: there
;;
;;     E = p_θ²/(2A) + p_φ²/(2I) + gMR cos θ + I (p_ψ − p_φ (C/I) cos θ)²/(2BC sin²θ)
;;
;; with I = B sin²θ + C cos²θ.  An island about a tilt, in a sea from upright to upside down.

(require mechanics/plot mechanics/book)

(define-values (A B C gMR) (values 3e-4 2.5e-4 1e-4 0.0456))
(define p-phi (* C 30))
(define energy (+ (* 1/2 C (square 30)) gMR))

(define (V s) (* gMR (cos (ref s 1 0))))
(define H (Lagrangian->Hamiltonian (- (T-body-Euler A B C) V)))

;; About the vertical, at ψ = 0
(define (inertia theta) (+ (* B (square (sin theta))) (* C (square (cos theta)))))

;; The energy left for the last term, and the state
(define (left theta p)
  (- energy (/ (square p) (* 2 A)) (/ (square p-phi) (* 2 (inertia theta))) (* gMR (cos theta))))
(define (section->top theta p)
  (define I (inertia theta))
  (define rest (left theta p))
  (and (>= rest 0)
       (up 0. (up theta 0. 0.)
           (down p p-phi (+ (/ (* p-phi C (cos theta)) I)
                            (* (sin theta) (sqrt (/ (* 2 B C rest) I))))))))

;; ---------------------------------------------------------------------------

(define rates (Hamiltonian->state-derivative H))
(define psi-is-0 (event (lambda (s) (sin (* 1/2 (ref s 1 2)))) #:name 'section))
(define crossing (Poincare-map rates psi-is-0 #:tolerance 1e-10))
(define (next-rising s)
  (define next (crossing s))
  (if (> (ref (rates next) 1 2) 0) next (next-rising next)))

(define (top-map theta p return fail)
  (define s (section->top theta p))
  (cond [s (define next (next-rising s))
           (return (ref next 1 0) (ref next 2 0))]
        [else (fail)]))

(define win (frame 0 :pi -0.009 0.009 #:x-label "θ" #:y-label "p_θ"))
(plot-contours win left '(0) #:samples 151 #:color 'gray)
(define sea (explore-map win top-map 450 #:starts (list (up 0.1 0.) (up 3. 0.))))
(define island
  (explore-map win top-map 150 #:color 1
               #:starts (for/list ([theta '(0.4 0.5 0.7 0.9 1.1 1.3 1.5)]) (up theta 0.))))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-22.png"))

(module+ test
  (require rackunit)
  (define (orbit theta p n)
    (for/fold ([all (list (section->top theta p))]) ([k n]) (cons (next-rising (car all)) all)))
  (define (tilts orbit) (map (lambda (s) (ref s 1 0)) orbit))
  (define steady (fixed-point-coordinates (find-fixed-point top-map (up 1.6 0.))))
  (test-case "energy and p_φ are those of the top upright, and p_ψ is the larger one"
    (for ([s (orbit 0.1 0. 20)])
      (check-= (H s) energy 1e-8)
      (check-= (ref s 2 1) p-phi 1e-12)
      (check-true (> (ref s 2 2) (/ (* p-phi C (cos (ref s 1 0))) (inertia (ref s 1 0)))))))
  (test-case "a tilt that comes back is stable"
    (check-equal? (fixed-point-kind (find-fixed-point top-map (up 1.6 0.))) 'elliptic)
    (check-= (ref steady 1) 0 1e-9))
  (test-case "it is nearly that at which the axisymmetric top precesses with this energy"
    (define mean (* 1/2 (+ A B)))
    (define (potential p-psi) (top-potential mean C gMR p-phi p-psi))
    (define (missed theta-and-p)
      (define U (potential (* C (ref theta-and-p 1))))
      (up (- (U (ref theta-and-p 0)) energy) ((D U) (ref theta-and-p 0))))
    (define s (section->top (ref steady 0) 0.))
    (define precession (find-root missed (up 1.5 (/ (ref s 2 2) C))))
    (check-= (ref precession 0) (ref steady 0) 0.05))
  (test-case "in the island the tilt keeps its bounds; from near upright it goes everywhere"
    (define regular (tilts (orbit 0.7 0. 100)))
    (check-true (< 0.69 (apply min regular) (apply max regular) 2.3))
    (define chaotic (map (lambda (v) (ref v 0)) (frame-points win)))
    (check-true (< (apply min chaotic) 0.1))
    (check-true (> (apply max chaotic) 3.))))
