#lang mechanics
;; Two families of homoclinic points  (SICM 4.3, Figure 4.8)
;;
;; The map keeps the sense in which the manifolds cross.  So between a crossing A and its image
;; there is another, B, in the other sense, and the images of these are a family of their own.

(require mechanics/plot "strobe.rkt" "tangle.rkt"
         (only-in racket/list argmin index-of))

(define central (list-ref crossings (quotient (length crossings) 2)))
(define between (list-ref crossings (+ 1 (quotient (length crossings) 2))))

;; A point's images, two before it and two after it
(define (family v)
  (define-values (once twice) (values (image v) (image (image v))))
  (define-values (back back-twice) (values (image-back v) (image-back (image-back v))))
  (list back-twice back v once twice))
(define-values (As Bs) (values (family central) (family between)))

(define picture (upper-half))
(draw-branch picture unstable #:color 'red)
(draw-branch picture stable #:color 'blue)
(for ([all (list As Bs)] [color '(black "dark green")] [label '("A" "B")])
  (for ([v all]) (plot-point picture (ref v 0) (ref v 1) #:size 7 #:color color #:label label)))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-4-8.png"))

(module+ test
  (require rackunit)
  (define (distance v w)
    (+ (abs ((principal-value :pi) (- (ref v 0) (ref w 0)))) (abs (- (ref v 1) (ref w 1)))))
  (define (place points v) (index-of points (argmin (lambda (w) (distance v w)) points)))
  (define (direction points v)
    (define k (place points v))
    (- (list-ref points (+ k 1)) (list-ref points (- k 1))))
  ;; From the stable manifold, as it goes to the saddle, to the unstable one as it leaves: to the
  ;; left or to the right
  (define (sense v)
    (define-values (s u) (values (- (direction stable v)) (direction unstable v)))
    (sgn (- (* (ref s 0) (ref u 1)) (* (ref s 1) (ref u 0)))))
  (test-case "the crossings found are of both families, in turn"
    (for ([v crossings] [w (list (cadr As) (cadr Bs) (caddr As) (caddr Bs) (cadddr As))])
      (check-true (< (distance v w) 1e-6))))
  (test-case "all A cross in one sense, all B in the other"
    (define senses (map (lambda (all) (map sense (cdr (reverse (cdr all))))) (list As Bs)))
    (check-equal? (length (car senses)) 3)
    (for ([a (car senses)]) (check-equal? a (caar senses)))
    (for ([b (cadr senses)]) (check-equal? b (- (caar senses)))))
  (test-case "they alternate on both manifolds"
    (for ([points (list unstable stable)])
      (define along
        (sort (for/list ([v crossings]) (place points v)) <))
      (define in-turn (map (lambda (v) (place points v)) crossings))
      (check-true (or (equal? along in-turn) (equal? along (reverse in-turn))))))
  (test-case "the lobes between them have one area"
    (define (height points theta)
      (for/first ([v points] [w (cdr points)]
                  #:when (<= (* (- (ref v 0) theta) (- (ref w 0) theta)) 0))
        (define part (/ (- theta (ref v 0)) (- (ref w 0) (ref v 0))))
        (+ (ref v 1) (* part (- (ref w 1) (ref v 1))))))
    (define (lobe v w)
      (define-values (low n) (values (ref v 0) 100))
      (define h (/ (- (ref w 0) low) n))
      (* h (for/sum ([k n])
             (define theta (+ low (* h (+ k 0.5))))
             (- (height unstable theta) (height stable theta)))))
    (define areas
      (for/list ([v (cdr crossings)] [w (cddr crossings)]) (lobe v w)))
    (check-true (> (abs (car areas)) 0.1))
    (for ([a areas] [b (cdr areas)]) (check-= (/ a b) -1 5e-3))))
