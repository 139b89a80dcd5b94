#lang racket/base
;; Orbits of a map of the plane, as points (SICM 3.6.1, p. 248).

(require racket/flonum
         "exploration-host.rkt"
         "../plot/plotted-number.rkt" "../plot/frame.rkt" "../plot/style.rkt"
         "../../error/complain.rkt" (only-in "../../error/progress.rkt" call-counting)
         "../../generic/define-plain.rkt" "../../generic/describe.rkt" "../../generic/on-demand.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         "../../dynamics/map/map-of-the-plane.rkt"
         "../../numeric/finite-number.rkt")

(require-on-demand ["../../dynamics/map/compiled-map.rkt" stepper-at]
                   ["../../dynamics/map/plane-points.rkt" check-grid part-middle]
                   ["explore-in-window.rkt" explore-in-window])

(provide explore-map display-map)

;; n : how many points each orbit has, or #f where the map is a collector, which follows an orbit
;; and shows its points (plot/following-orbits.rkt); starts : a list of points;
;; grid : (list across up)
;; color : of the first orbit; window? : is it to be explored in a window?
;; source : the expression of the map, for the program that a window saves
;; -> the frame
(define-plain (explore-map f map [n 1000] #:starts [given-starts #f] #:grid [grid #f]
                     #:size [size #f] #:color [color 0]
                     #:window? [window? (not (or given-starts grid))] #:source [source #f])
  (define who 'explore-map)
  (check-exploration who f map (or n 0))
  (check-argument who exact-nonnegative-integer? color "a small natural number as the first color")
  (define given (if given-starts (checked-starts who f given-starts) '()))
  (define starts (append given (if grid (grid-starts who f grid) '())))
  (cond [(not n) (collect-orbits who f map given (list-tail starts (length given)) window?)]
        [else
         (for ([p (in-list given)]) (check-image who f map (car p) (cdr p)))
         (if window?
             ((or (current-exploration-host) explore-in-window) who f map n starts source)
             (draw-orbits who f map n starts color size))])
  f)

;; A collector complains of given starts without an image; starts of a grid may have none.
(define (collect-orbits who f collector given grid window?)
  (when window?
    (complain who
              (string-append "a collector follows its orbits by itself, from starts that are "
                             "given, not in a window\n  "
                             "(explore-map f collector #f #:starts (list (up x y) ...)), or #:grid (list 5 5)")))
  (call-counting
   who "orbits" (+ (length given) (length grid))
   (lambda (count!)
     (for ([p (in-list (append given grid))] [k (in-naturals)])
       (define (none) (when (< k (length given)) (raise-no-image who collector (car p) (cdr p))))
       (count! k)
       (collector (car p) (cdr p) void none)))))

;; One orbit, by the convention of scmutils.
(define (display-map f map x y n)
  (check-exploration 'display-map f map n)
  (define-values (x0 y0)
    (values (check-number 'display-map "the abscissa" x)
            (check-number 'display-map "the ordinate" y)))
  (check-image 'display-map f map x0 y0)
  (draw-orbits 'display-map f map n (list (cons x0 y0)) 0 #f)
  f)

;; starts : pairs; color : of the first orbit
(define (draw-orbits who f map n starts color size)
  (call-counting
   who "points" (* (+ n 1) (length starts))
   (lambda (count!)
     (for ([p (in-list starts)] [k (in-naturals)])
       (draw-orbit who f map n (car p) (cdr p) (+ color k) size
                   (lambda (left) (count! (- (* (+ n 1) (+ k 1)) left))))))))

;; The start is drawn as well.  It ends early where there is no image.  left! : number -> any,
;; how many points are left
(define (draw-orbit who f map n x y color size left!)
  (define p (flvector x y))
  (define step! (stepper-at who map x y))
  (define style (make-style who 'points color size 'solid #f))
  (define (draw) (add-dot! who f style (flvector-ref p 0) (flvector-ref p 1)))
  (when step!
    (draw)
    (let loop ([n n])
      (left! n)
      (when (and (> n 0) (step! p))
        (draw)
        (loop (- n 1))))))

;; ---------------------------------------------------------------------------
;; Where orbits start

(define (check-exploration who f map n)
  (check-plain who f)
  (check-map who map)
  (check-argument who exact-nonnegative-integer? n
                  "how many points an orbit has, a natural number"))

(define (checked-starts who f starts)
  (unless (list? starts)
    (complain who "#:starts is a list of points to start at; given ~a~a"
              (describe-with-value starts)
              (if (tuple? starts)
                  (format "\n  one point in a list: (list ~a)" (value->text starts))
                  "")))
  (for/list ([p (in-list starts)] [k (in-naturals)])
    (define-values (x y) (plane-point who (lambda () (format "start ~a" k)) p))
    (unless (and (finite? x) (finite? y))
      (complain who "start ~a is not of finite numbers\n  given: ~a" k (describe-with-value p)))
    (cons x y)))

(define (check-image who f map x y)
  (unless (image? who map x y)
    (complain who "the map has no image of the start ~a\n  map: ~a~a"
              (value->text (up x y)) (value->text map) (where-allowed who f map y))))

;; Names the abscissas in the frame where, at that ordinate, the map has images: for a section,
;; those that the energy allows.
(define (where-allowed who f map y)
  (define-values (x-min x-max y-min y-max) (apply values (frame-bounds f)))
  (define (at k) (+ x-min (* (- x-max x-min) (/ k 200.0))))
  (define (allowed? x) (image? who map x y))
  (define inside (for/list ([k (in-range 201)] #:when (allowed? (at k))) k))
  (define (edge in out)
    (for/fold ([in in] [out out] #:result in) ([_ (in-range 30)])
      (define middle (* 0.5 (+ in out)))
      (if (allowed? middle) (values middle out) (values in middle))))
  (if (null? inside)
      (format "\n  in the frame it has none for the ordinate ~a" y)
      (let ([first (car inside)] [last (car (reverse inside))])
        (format "\n  for the ordinate ~a it has images of abscissas from ~a to ~a" y
                (if (= first 0) x-min (edge (at first) (at (- first 1))))
                (if (= last 200) x-max (edge (at last) (at (+ last 1))))))))

;; -> the middles of equal parts of the frame, (list across up) of them
(define (grid-starts who f grid)
  (check-grid who grid)
  (define-values (x-min x-max y-min y-max) (apply values (frame-bounds f)))
  (for*/list ([j (in-range (cadr grid))] [i (in-range (car grid))])
    (cons (part-middle x-min x-max i (car grid)) (part-middle y-min y-max j (cadr grid)))))
