#lang racket/base
;; Points at which a quadrature that would end looks for features it has not seen.
;;
;; A peak between the nodes of a panel leaves no trace in their values.  Points spread over the
;; interval, 192 to its length, find one that is a thousandth of it wide; they are left out
;; where panels are so narrow that their own nodes are as close.  Others close in on both ends,
;; and on 0 if it lies between, in steps of a factor 16, for the mass of e^(−x) over 0 … 10⁶ is
;; there; and on places of peaks that are given.  Where a value differs from the polynomial of its
;; panel by more than that may be wrong, the panel is *suspect*.  Of a function that was 0 wherever
;; it was seen, peaks are sought five times as closely, and to the smallest numbers.
;;
;; The error of the polynomial follows from the estimate of panel.rkt, whose error to
;; the power 2/3 is the distance of two rules: about tolerance^(2/3) of the mean of |f|,
;; as long as the panel is not so narrow that it does not matter.
;;
;; A jump may hide, too, between the edge of two panels and their nodes next to it: then the two
;; polynomials differ there, and f close to the edge tells which of them is wrong.

(require racket/flonum racket/list
         "panel.rkt"
         (only-in "../constants.rkt" spread-fraction)
         "../../error/failure.rkt")

(provide take-probes suspects suspects-at-edges)

(struct probe (x y) #:authentic)

;; -> a list in increasing order of x; f has no value at some, as ∞ · 0 far out
;; panels : from the left; seen? : was f anything but 0?; places : of peaks
(define (take-probes f panels seen? places)
  (define low (panel-least (first panels)))
  (define high (panel-greatest (last panels)))
  (define width (fl- high low))
  (define points
    (append (closing-in low width seen?)
            (spread-points panels low width (if seen? 192 1000))
            (closing-in high (fl- 0.0 width) seen?)
            (append*
             (for/list ([c (in-list (remove-duplicates (cons 0.0 places)))] #:when (fl< low c high))
               (append (closing-in c (fl- high c) seen?) (closing-in c (fl- low c) seen?))))))
  (probes-at f (filter (lambda (x) (fl< low x high)) (sort points fl<))))

;; One handler for all points: a new one for each takes longer than most functions.
(define (probes-at f points)
  (define left points)
  (define found '())
  (define (go-on)
    (unless (null? left)
      (define x (car left))
      (set! left (cdr left))
      (set! found (cons (probe x (f x)) found))
      (go-on)))
  (let again ()
    (with-handlers ([exn:fail:mechanics:singular? void]) (go-on))
    (unless (null? left) (again)))
  (reverse found))

(define nodes-per-panel 14.0)           ; that many would be as far apart as its nodes are at most

;; In the middle of n cells, or nearly
(define (spread-points panels low width n)
  (define cell (fl/ width (->fl n)))
  (let loop ([k 0] [panels panels] [points '()])
    (define x (fl+ low (fl* cell (fl+ (->fl k) (fl+ 0.45 (fl* 0.1 (spread-fraction k)))))))
    (cond [(or (= k n) (null? panels)) points]
          [(fl> x (panel-greatest (car panels))) (loop k (cdr panels) points)]
          [(fl< (panel-width (car panels)) (fl* nodes-per-panel cell)) (loop (+ k 1) panels points)]
          [else (loop (+ k 1) panels (cons x points))])))

;; Points that come nearer and nearer to the end; for an end 0, one that is almost there
(define (closing-in end width seen?)
  (define (at k) (fl+ end (fl* width (flexpt 0.5 (->fl k)))))
  (cons (at 990) (for/list ([k (if seen? (in-range 10 55 4) (in-range 12 900 12))]) (at k))))

;; ---------------------------------------------------------------------------

;; A panel is suspect if a value is wrong by `most` and the area by `matters`.
(struct threshold (most matters) #:authentic)

(define (threshold-of tolerance size width)
  (threshold (fl* 0.1 (fl/ (fl* (flexpt tolerance (fl/ 2.0 3.0)) size) width))
             (fl* 0.1 (fl* tolerance size))))

(define (off? y polynomial width t)
  (define off (flabs (fl- y polynomial)))
  (and (fl> off (threshold-most t)) (fl> (fl* off width) (threshold-matters t))))

;; The panels whose polynomials are wrong at a probe; and those probes that are in them, for
;; others need not be looked at again.  size ≈ ∫ |f| over the whole width.
(define (suspects panels probes tolerance size width)
  (define t (threshold-of tolerance size width))
  (define (wrong? p q)
    (off? (probe-y q) (panel-polynomial p (probe-x q)) (panel-width p) t))
  (let loop ([panels panels] [probes probes] [found '()] [again '()])
    (cond [(or (null? panels) (null? probes)) (values found (reverse again))]
          [else
           (define p (car panels))
           (define-values (inside beyond)
             (splitf-at probes (lambda (q) (fl<= (probe-x q) (panel-greatest p)))))
           (if (ormap (lambda (q) (wrong? p q)) inside)
               (loop (cdr panels) beyond (cons p found) (append (reverse inside) again))
               (loop (cdr panels) beyond found again))])))

(define strip 0.005)                   ; of a panel is outside of its nodes

;; The panels that are wrong at an edge between two.
(define (suspects-at-edges f panels tolerance size width)
  (define t (threshold-of tolerance size width))
  (for/fold ([found '()]) ([p (in-list panels)] [q (in-list (cdr panels))])
    (define edge (panel-greatest p))
    (define-values (from-p from-q) (values (panel-polynomial p edge) (panel-polynomial q edge)))
    (define (wrong-beside? p polynomial)
      (define aside (fl* 1e-3 (fl* strip (fl- (panel-centre p) edge))))
      (for/or ([q (in-list (probes-at f (list (fl+ edge aside))))])
        (off? (probe-y q) polynomial (fl* strip (panel-width p)) t)))
    (cond [(off? from-p from-q (fl* strip (flmax (panel-width p) (panel-width q))) t)
           (append (if (wrong-beside? p from-p) (list p) '())
                   (if (wrong-beside? q from-q) (list q) '())
                   found)]
          [else found])))
