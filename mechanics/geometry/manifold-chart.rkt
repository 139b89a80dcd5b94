#lang racket/base
;; Manifolds, patches and coordinate systems.
;;
;; A manifold of dimension n is known by a place in a space that holds it: the sphere S² by the
;; unit vectors of R³, a rotation by its matrix.  A coordinate system is a map from coordinates
;; to that place and one back; between two systems one goes by way of the place.  Manifolds of
;; one type share patches and systems, for all dimensions that these allow.
;;
;; A system may also be made for one manifold alone, from its two maps.
;;
;; Systems that differ only in the names of their coordinates are the same chart: its identity is
;; the vector of symbols that stand for the coordinates of a generic point.

(require "../error/complain.rkt" "../error/message-words.rkt"
         "../generic/describe.rkt" "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt")

(provide make-manifold-type attach-patch attach-coordinate-system
         make-manifold manifold? manifold-dimension manifold-charts
         patch coordinate-system-at coordinate-system make-coordinate-system
         coordinate-system? coordinate-system-manifold coordinate-system-dimension
         coordinate-system-names coordinate-system-symbols coordinate-system-positive
         coordinates->place place->coordinates coordinate-system-to
         same-chart? on-one-manifold? once-a-chart check-coordinate-system with-coordinate-names
         coordinate-tuple)

;; ---------------------------------------------------------------------------
;; Types

;; patches : names;  recipes : the systems that may be asked for, the last attached first
(value-struct family (name [patches #:mutable] [recipes #:mutable])
  #:datum family-name)

;; makes : dimension -> (list coordinates->place place->coordinates names positive); #f for
;; dimensions that the system is not for
(struct recipe (patch name makes) #:authentic)

(define (make-manifold-type name . patches)
  (check-argument 'make-manifold-type symbol? name "a quoted name")
  (family name patches '()))

(define (attach-patch name type)
  (check-argument 'attach-patch symbol? name "the quoted name of a patch")
  (check-argument 'attach-patch family? type "a type of manifolds")
  (set-family-patches! type (append (family-patches type) (list name))))

;; to-place, to-coordinates : dimension -> map; coordinates are an up tuple, or a number where the
;; dimension is 1.  allowed : list of dimensions, #f for all.  names : dimension -> symbols
;; positive : dimension -> coordinates -> list of values positive in the chart, as a radius is
(define (attach-coordinate-system name patch type to-place to-coordinates
                                  #:dimensions [allowed #f] #:names [names numbered-names]
                                  #:positive [positive (lambda (n) (lambda (x) '()))])
  (define who 'attach-coordinate-system)
  (check-argument who family? type "a type of manifolds")
  (check-known who "patch" patch (family-patches type))
  (define (makes n)
    (and (or (not allowed) (memv n allowed))
         (for/list ([make (in-list (list to-place to-coordinates names positive))]) (make n))))
  (set-family-recipes! type (cons (recipe patch name makes) (family-recipes type))))

(define (numbered-names n) (for/list ([k (in-range n)]) (string->symbol (format "x~a" k))))

(define (check-known who what given known)
  (unless (memq given known)
    (complain who "there is no ~a of the name ~a here\n  there are: ~a" what given
              (joined (map symbol->string known) ", "))))

;; ---------------------------------------------------------------------------
;; Manifolds

;; systems : (patch . name) -> coordinate system, filled as they are asked for
(value-struct manifold (name family dimension systems)
  #:datum manifold-name)

;; (make-manifold R^n 3), or with the name that it is to have in print
(define (make-manifold type n [name #f])
  (check-argument 'make-manifold family? type "a type of manifolds, such as R^n")
  (check-argument 'make-manifold exact-positive-integer? n "the dimension, 1 or more")
  (manifold (if (symbol? name) name `(make-manifold ,(family-name type) ,n))
            type n (make-hash)))

(value-struct patch-of (name manifold)
  #:datum (lambda (p) `(patch ,(patch-of-name p) ,(value->datum (patch-of-manifold p)))))

(define (patch name manifold)
  (check-argument 'patch manifold? manifold "a manifold")
  (check-known 'patch "patch" name (family-patches (manifold-family manifold)))
  (patch-of name manifold))

;; ---------------------------------------------------------------------------
;; Coordinate systems

;; to : coordinates -> place;  from : place -> coordinates
;; names : vector of the names of the coordinates
;; symbols : vector of uninterned symbols, the coordinates of a generic point
;; positive : coordinates -> list of values that are positive in the chart
(value-struct system (name manifold to from names symbols positive)
  #:datum system-name)

(define (coordinate-system? x) (system? x))
(define (coordinate-system-manifold C) (system-manifold C))
(define (coordinate-system-to C) (system-to C))
(define (coordinate-system-names C) (system-names C))
(define (coordinate-system-symbols C) (system-symbols C))
;; By the coordinates, the generic ones if none are given
(define (coordinate-system-positive C [x (coordinate-tuple (system-symbols C))])
  ((system-positive C) x))
(define (coordinate-system-dimension C) (manifold-dimension (system-manifold C)))
(define (coordinates->place C x) ((system-to C) x))
(define (place->coordinates C place) ((system-from C) place))

(define (coordinate-system name patch)
  (check-argument 'coordinate-system patch-of? patch "a patch, such as (patch 'origin R2)")
  (coordinate-system-at name (patch-of-name patch) (patch-of-manifold patch)))

;; All that there are
(define (manifold-charts m)
  (for/list ([r (in-list (manifold-family-recipes m))]
             #:when ((recipe-makes r) (manifold-dimension m)))
    (coordinate-system-at (recipe-name r) (recipe-patch r) m)))

(define (manifold-family-recipes m) (reverse (family-recipes (manifold-family m))))

;; The same system each time it is asked for.  printed : how it prints, if not as this call
(define (coordinate-system-at name patch-name m [printed #f])
  (define who 'coordinate-system-at)
  (check-argument who manifold? m "a manifold")
  (define type (manifold-family m))
  (check-known who "patch" patch-name (family-patches type))
  (define there
    (for/list ([r (in-list (family-recipes type))] #:when (eq? (recipe-patch r) patch-name))
      r))
  (check-known who "coordinate system" name (map recipe-name there))
  (hash-ref! (manifold-systems m) (cons patch-name name)
             (lambda ()
               (make-system (or printed `(coordinate-system-at ,name ,patch-name ,(value->datum m)))
                            m name there))))

(define (make-system printed m name recipes)
  (define n (manifold-dimension m))
  (define made
    (for/or ([r (in-list recipes)] #:when (eq? (recipe-name r) name)) ((recipe-makes r) n)))
  (unless made
    (complain 'coordinate-system-at "there are no coordinates ~a in ~a dimension~a"
              name n (if (= n 1) "" "s")))
  (apply make-coordinate-system printed m made))

;; printed : the datum that it prints as;  positive : coordinates -> list
(define (make-coordinate-system printed m to from names [positive (lambda (x) '())])
  (system printed m to from (list->vector names) (generic-symbols names) positive))

(define (generic-symbols names)
  (for/vector ([s (in-list names)]) (string->uninterned-symbol (symbol->string s))))

(define (same-chart? A B) (eq? (system-symbols A) (system-symbols B)))
(define (on-one-manifold? A B) (eq? (system-manifold A) (system-manifold B)))

;; The function f of coordinate systems, called once for each chart.  Its value is kept as long
;; as the chart is.
(define (once-a-chart f)
  (define known (make-ephemeron-hasheq))
  (lambda (C) (hash-ref! known (system-symbols C) (lambda () (f C)))))

;; The same chart with other names, a vector.
(define (with-coordinate-names C names) (struct-copy system C [names names]))

(define (check-coordinate-system who C)
  (check-argument who coordinate-system? C "a coordinate system, such as R3-rect"))

;; The coordinates xs, a vector, as points are given them: a number where there is only one.
(define (coordinate-tuple xs)
  (if (= (vector-length xs) 1) (vector-ref xs 0) (up-of xs)))
