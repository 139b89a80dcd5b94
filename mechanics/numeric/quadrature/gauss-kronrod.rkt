#lang racket/base
;; Definite integrals by adaptive Gauss–Kronrod quadrature.
;;
;; Panels (panel.rkt) are halved, in each round those with an estimate of more than half of
;; the greatest, until the sum of the estimates is at most the tolerance times ∫ |f| over the
;; whole interval: the error is measured against the size of the integrand, so that an
;; integral which is zero by symmetry is no exception.  At a singularity a round is one
;; panel, where a function oscillates it is most of them; so the sums, made anew in each,
;; cost little.
;;
;; A rule that samples is blind between its nodes.  So, where it is asked
;; to, the method looks at other points (probe-points.rkt) when it would end; panels whose
;; polynomials are wrong there are halved, too.

(require racket/flonum racket/list
         "panel.rkt" "probe-points.rkt"
         "../checked-arguments.rkt"
         "../../error/failure.rkt" "../../error/refusal.rkt")

(provide
 quadrature            ; (quadrature f low high) -> flonum
 quadrature/error      ; the same -> (values flonum error-bound)
 part-integral)

;; ---------------------------------------------------------------------------
;; The whole interval

(define (quadrature f low high
                    #:tolerance [tolerance 1e-10]
                    #:limit [limit most-panels]
                    #:name [who 'quadrature])
  (define-values (value bound)
    (quadrature/error f low high
                      #:tolerance tolerance #:limit limit #:name who))
  value)

;; A part of an integral, a hundred times as precise, or #f.
(define (part-integral f low high tolerance limit)
  (if-raised exn:fail:mechanics? #f
    (quadrature f low high #:tolerance (max 1e-13 (* 1e-2 tolerance)) #:limit limit)))

;; A tolerance below twice the rounding error is taken as that.  `limit` bounds
;; the number of panels.  (edge) is called when a narrow panel at an end of the
;; interval is to be halved, unless between the nodes something was found; (stuck value
;; bound x) when no halving helps, at an x where a panel cannot be halved any more, or #f if
;; there are too many; (place x) is the user's variable for x; (search?) tells whether to look
;; between the nodes, and (peaks) near which numbers, as flonums, too.
(define (quadrature/error f low high
                          #:tolerance [tolerance 1e-10]
                          #:limit [limit most-panels]
                          #:place [place values]
                          #:edge [edge void]
                          #:stuck [stuck void]
                          #:search? [search? never]
                          #:peaks [peaks list]
                          #:name [who 'quadrature])
  (check-finite who low "limit of integration")
  (check-finite who high "limit of integration")
  (check-tolerance who tolerance)
  (define (g x) (sample who f x))
  (define whole
    (integrate-panel g (real->double-flonum low) (real->double-flonum high)))
  (define (raise-stuck value bound worst)
    (define x (panel-centre worst))
    (stuck value bound (and (indivisible? worst whole) x))
    (raise-unknown-integral who value bound (place x)))
  (define tolerated (max (real->double-flonum tolerance) (* 2.0 rounding)))
  (define (raise-rounded value bound worst)
    (raise-rounded-integral who value bound (place (panel-centre worst))))
  (define t (task g whole tolerated limit raise-stuck raise-rounded edge search? peaks))
  (refine t (list whole) 1 #f))

(define (never) #f)

(define most-panels 10000)

;; Constants of the halving; whole : the first panel
(struct task (f whole tolerance limit raise-stuck raise-rounded edge search? peaks) #:authentic)

;; count : how many panels; probes : #f as long as none were taken
(define (refine t panels count probes)
  (define-values (value bound size worst) (totals panels))
  (define whole (task-whole t))
  (cond [(<= bound (* (task-tolerance t) size)) (search t panels count probes value bound size)]
        [(or (>= count (task-limit t)) (indivisible? worst whole))
         ((task-raise-stuck t) value bound worst)]
        [else
         (define threshold (fl* 0.5 (panel-error worst)))
         (define (poor? p)
           (and (or (eq? p worst)
                    (and (fl> (panel-error p) threshold) (not (indivisible? p whole))))
                (begin (when (and (not probes) (at-edge? p whole)) ((task-edge t)))
                       #t)))
         (define-values (next added) (halve poor? panels (task-f t)))
         (refine t next (+ count added) probes)]))

;; Ends with this value, unless other points contradict some panels.
(define (search t panels count taken value bound size)
  (cond
    [((task-search? t))
     (define whole (task-whole t))
     (define sorted (panels-from-the-left panels))
     (define probes (or taken (take-probes (task-f t) sorted (fl> size 0.0) ((task-peaks t)))))
     (define-values (all-wrong again) (contradicted t sorted probes size))
     (define wrong (filter (lambda (p) (not (indivisible? p whole))) all-wrong))
     (cond [(null? wrong) (finish t panels value bound size)]
           [(>= count (task-limit t)) ((task-raise-stuck t) value bound (car wrong))]
           [else
            (define-values (next added)
              (halve (lambda (p) (memq p wrong)) panels (task-f t)))
            (refine t next (+ count added) again)])]
    [else (values value bound)]))

;; -> panels, and probes to be looked at again
(define (contradicted t panels probes size)
  (define-values (tolerance width) (values (task-tolerance t) (panel-width (task-whole t))))
  (define-values (found again) (suspects panels probes tolerance size width))
  (values (if (null? found) (suspects-at-edges (task-f t) panels tolerance size width) found)
          again))

;; The rounding of nodes is counted at the end, for halving does not make it less; and only of
;; whole integrals: of parts towards a point where f is infinite it would be too much.
(define (finish t panels value bound size)
  (define unsure (rounding-of-nodes panels))
  (if (<= unsure (* (task-tolerance t) size))
      (values value (fl+ bound unsure))
      ((task-raise-rounded t) value (fl+ bound unsure) (argmax rounding-of-panel panels))))

;; -> panels, and how many more there are
(define (halve which? panels f)
  (for/fold ([next '()] [added 0]) ([p (in-list panels)])
    (cond [(which? p)
           (define centre (panel-centre p))
           (values (list* (integrate-panel f (panel-low p) centre)
                          (integrate-panel f centre (panel-high p))
                          next)
                   (+ added 1))]
          [else (values (cons p next) added)])))

;; -> the sums of values, of errors and of sizes, and the panel of greatest error
(define (totals panels)
  (for/fold ([value 0.0] [bound 0.0] [size 0.0] [worst (car panels)]) ([p (in-list panels)])
    (values (fl+ value (panel-value p))
            (fl+ bound (panel-error p))
            (fl+ size (panel-size p))
            (if (fl> (panel-error p) (panel-error worst)) p worst))))

(define narrow (expt 0.5 12))

(define (at-edge? p whole)
  (and (or (fl= (panel-low p) (panel-low whole)) (fl= (panel-high p) (panel-high whole)))
       (fl< (panel-width p) (fl* narrow (panel-width whole)))))

;; Too narrow for its nodes to be different numbers, or after so many halvings that
;; the function must be infinite there.
(define narrowest (expt 0.5 200))

(define (indivisible? p whole)
  (or (fl<= (panel-width p) (fl* 1e-14 (flabs (panel-centre p))))
      (fl<= (panel-width p) (fl* narrowest (panel-width whole)))))
