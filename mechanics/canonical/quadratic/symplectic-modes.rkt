#lang racket/base
;; The normal form of a quadratic Hamiltonian z·A z/2 of several coordinates, by flonums.
;;
;; The motions are ż = B z with B = J A, whose eigenvalues come as ±iω, as ±λ, or as ±λ, ±λ*.
;; Eigenvalues that are near one another span a space together, found by inverse iteration, as
;; each alone has no certain vector.  Those near 0 make a smaller quadratic form, on the space of
;; those directions; oscillators of near frequencies are told apart by Hermitian-modes.rkt; a
;; growing vector, Bξ = λξ, is paired with a decaying one, Bη = −λη, by ξᵀJη = 1.
;;
;; Coordinates get units first, by which each is about as stiff as it is light.

(require racket/list
         "Hermitian-modes.rkt" "quadratic-pair.rkt"
         "../../numeric/complex-vector.rkt"
         "../../numeric/linear-algebra/flonum-systems.rkt"
         "../../numeric/linear-algebra/general-eigenvalues.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../numeric/vector-map.rkt"
         "../../value/matrix/row-products.rkt")

(provide symplectic-modes (struct-out placed))

;; A block, and the coordinates whose places it takes
(struct placed (coordinates block) #:authentic)

;; A : symmetric rows of 2n real numbers; (stop trouble) ends the work
;; -> a list of placed: coordinates that do not act on one another keep their places; among those
;;    that do, frequencies rise
(define (symplectic-modes A tolerance stop)
  (define n (quotient (vector-length A) 2))
  (define units (units-of (rows-map real->double-flonum A)))
  (define balanced (in-units A units))
  (define size (greatest-entry balanced))
  (define small (if (exact-numbers? A) 0 (* tolerance size)))
  (define (joined? i j)
    (for*/or ([k (in-list (list i (+ n i)))] [l (in-list (list j (+ n j)))])
      (> (abs (entry balanced k l)) small)))
  (append*
   (for/list ([group (in-list (joined-groups n joined?))])
     (define scalars (append group (map (lambda (j) (+ n j)) group)))
     (define exact? (and (null? (cdr group)) (exact-numbers? A)))
     (define part (submatrix (if exact? A balanced) scalars scalars))
     (define blocks
       (if exact? (list (pair-of part 0 1 stop)) (modes-of part size tolerance stop)))
     (place group (for/list ([b (in-list blocks)])
                    (spread b scalars (if exact? (make-vector (* 2 n) 1) units)))))))

(define (pair-of part tolerance size stop)
  (quadratic-pair (entry part 0 0) (entry part 0 1) (entry part 1 1) tolerance size stop))

;; The block of these scalars as one of all
(define (spread b scalars units)
  (define (wide v)
    (define all (make-vector (vector-length units) 0))
    (for ([x (in-vector v)] [k (in-list scalars)])
      (vector-set! all k (* x (vector-ref units k))))
    all)
  (block (block-frequencies b) (map wide (block-qs b)) (map wide (block-ps b))))

(define (place coordinates blocks)
  (define (size b) (magnitude (car (block-frequencies b))))
  (for/fold ([found '()] [left coordinates] #:result (reverse found))
            ([b (in-list (sort blocks < #:key size))])
    (define-values (own others) (split-at left (length (block-frequencies b))))
    (values (cons (placed own b) found) others)))

;; Powers of two, of coordinates and, the inverses, of momenta
(define (units-of A)
  (define n (quotient (vector-length A) 2))
  (for/fold ([units (make-vector (* 2 n) 1.0)]) ([_ 4])
    (define rows (in-units A units))
    (define (size k) (for/fold ([m 0.0]) ([x (in-vector (vector-ref rows k))]) (max m (abs x))))
    (define changes
      (for/list ([j (in-range n)])
        (define-values (q p) (values (size j) (size (+ n j))))
        (if (or (= q 0.0) (= p 0.0)) 1.0 (expt 2.0 (round (/ (log (/ p q)) (log 16.0)))))))
    (for/vector ([u (in-vector units)] [c (in-list (append changes (map / changes)))])
      (* u c))))

(define (in-units A units)
  (for/vector ([row (in-vector A)] [u (in-vector units)])
    (for/vector ([x (in-vector row)] [w (in-vector units)]) (* u x w))))

;; ---------------------------------------------------------------------------
;; Eigenvalues that are near one another

;; size : of the whole form
(define (modes-of A size tolerance stop)
  (define n (quotient (vector-length A) 2))
  (define greatest (greatest-entry A))
  (cond
    [(<= greatest (* tolerance size)) (identity-blocks n)]
    [(= n 1) (list (pair-of A tolerance size stop))]
    [else
     (define B (times-J A))
     (define near (* 2 (expt tolerance 1/4) greatest))
     (append* (for/list ([cluster (in-list (clusters (real-matrix-eigenvalues
                                                      (rows->flvector B) (* 2 n)) near))])
                (cluster-modes A B cluster near size tolerance stop)))]))

;; J A
(define (times-J A)
  (define n (quotient (vector-length A) 2))
  (for/vector #:length (* 2 n) ([k (in-range (* 2 n))])
    (if (< k n)
        (vector-ref A (+ n k))
        (for/vector ([x (in-vector (vector-ref A (- k n)))]) (- x)))))

;; Lists of eigenvalues, with those that they come with
(define (clusters found near)
  (define values (list->vector found))
  (define (corner k)
    (define z (vector-ref values k))
    (make-rectangular (abs (real-part z)) (abs (imag-part z))))
  (define (near? i j) (<= (magnitude (- (corner i) (corner j))) near))
  (for/list ([group (in-list (joined-groups (vector-length values) near?))])
    (for/list ([k (in-list group)]) (vector-ref values k))))

(define (cluster-modes A B cluster near size tolerance stop)
  (define (some-small? part) (ormap (lambda (z) (<= (abs (part z)) near)) cluster))
  (define (growing)
    (define (grows? z) (and (> (real-part z) 0.0) (>= (imag-part z) 0.0)))
    (growing-modes B (filter grows? cluster) size tolerance stop))
  (cond [(some-small? magnitude) (slow-modes A B cluster size tolerance stop)]
        [(some-small? real-part)
         (define upper (filter (lambda (z) (> (imag-part z) 0.0)) cluster))
         (define center (* 0+1i (/ (apply + (map imag-part upper)) (length upper))))
         (or (Hermitian-modes A (invariant-basis B (length upper) center size stop)
                              size tolerance stop)
             (growing))]
        [else (growing)]))

;; ---------------------------------------------------------------------------
;; Modes of frequencies near 0

;; The form on the space of these directions, in coordinates of its own.  If that is all there is,
;; its frequencies are nothing beside its entries.
(define (slow-modes A B cluster size tolerance stop)
  (define n (quotient (vector-length A) 2))
  (define m (quotient (length cluster) 2))
  (when (and (= m n) (> n 1))
    (define distance (/ (apply max (map magnitude cluster)) (greatest-entry A)))
    (stop (trouble (if (<= distance (sqrt tolerance)) 'not-semisimple 'undecided)
                   (map magnitude (take cluster m)) distance)))
  (define basis (symplectic-basis (invariant-basis B (* 2 m) 0.0 size stop)))
  (define small
    (for/vector ([v (in-list basis)]) (for/vector ([w (in-list basis)]) (energy-of A v w))))
  (define (back c) (combination (vector->list c) basis))
  (for/list ([b (in-list (modes-of (symmetric-rows small) size tolerance stop))])
    (block (block-frequencies b) (map back (block-qs b)) (map back (block-ps b)))))

;; q₁ … p₁ … with areas 1, of a space of real vectors: the pair of the greatest area is taken, and
;; its share in the others is taken from them.
(define (symplectic-basis vectors)
  (let loop ([rest vectors] [qs '()] [ps '()])
    (cond
      [(null? rest) (append (reverse qs) (reverse ps))]
      [else
       (define q (car rest))
       (define p (argmax (lambda (v) (abs (area-of q v))) (cdr rest)))
       (define p* (times (/ (area-of q p)) p))
       (loop (for/list ([v (in-list (remq p (cdr rest)))])
               (vector-sum v (vector-sum (times (- (area-of v p*)) q) (times (area-of v q) p*))))
             (cons q qs) (cons p* ps))])))

;; ---------------------------------------------------------------------------
;; Modes that grow and decay

;; lambdas : with positive real part, of which those above the real line stand for their conjugates
(define (growing-modes B lambdas size tolerance stop)
  (define m (length lambdas))
  (define mean (/ (apply + lambdas) m))
  (define (basis sign) (invariant-basis B m (* sign mean) size stop))
  (cond [(= m 1) (paired mean (basis 1) (basis -1))]
        [(not (spread-out? B (basis 1) mean size tolerance))
         (paired (if (real? (car lambdas)) (real-part mean) mean) (basis 1) (basis -1))]
        [else
         (check-separate lambdas B (basis 1) mean tolerance stop)
         (append-map (lambda (z) (growing-modes B (list z) size tolerance stop)) lambdas)]))

;; B less the mean of its eigenvalues, on the space of the vectors
(define (rest-of B vectors mean)
  (for*/fold ([greatest 0.0]) ([v (in-list vectors)] [w (in-list vectors)])
    (max greatest (magnitude (- (energy-of B v w) (if (eq? v w) mean 0))))))

(define (spread-out? B vectors mean size tolerance)
  (> (rest-of B vectors mean) (* tolerance size)))

;; Eigenvalues ±δ about their mean are δ²/|B − mean| away from one that has too few vectors.
(define (check-separate lambdas B vectors mean tolerance stop)
  (define size (rest-of B vectors mean))
  (define least
    (for*/fold ([d +inf.0]) ([pair (in-combinations lambdas 2)])
      (min d (magnitude (/ (- (car pair) (cadr pair)) 2)))))
  (define distance (/ (* least least) size (greatest-entry B)))
  (when (<= distance (sqrt tolerance))
    (stop (trouble (if (<= distance tolerance) 'not-semisimple 'undecided)
                   (map (lambda (z) (* 0+1i z)) (take lambdas 2)) distance))))

;; xis, etas : bases of the growing and of the decaying vectors
(define (paired lambda xis etas)
  (define areas
    (for/vector ([x (in-list xis)])
      (for/vector ([e (in-list etas)]) (area-of (conjugated x) e))))
  (define duals (floating-solutions areas (unit-rows (length xis) 1.0 0.0)))
  (for/list ([x (in-list xis)] [k (in-naturals)])
    (define e
      (combination (for/list ([row (in-vector duals)]) (vector-ref row k)) etas))
    (define balance (sqrt (/ (norm e) (norm x))))
    ((if (real? lambda) saddle-of complex-saddle) lambda (times balance x) (times (/ balance) e))))

(define (saddle-of lambda x e)
  (define sign (if (< (for/first ([c (in-vector x)] #:unless (< (abs c) 1e-9)) c) 0) -1 1))
  (saddle-block lambda (times sign x) (times sign e)))

;; Re λ (q₁p₁ + q₂p₂) + Im λ (q₁p₂ − q₂p₁) is Re λ u v for u = q₁ + i q₂, v = p₁ − i p₂.  With
;; ξᵀJη = 1/2 the state is 2 Re (u ξ + v η).
(define (complex-saddle lambda x e)
  (define (part of c v) (times c (vector-map of v)))
  (define f (sqrt 2.0))
  (block (list (* 0+1i lambda) (* 0+1i (conjugate lambda)))
         (list (part real-part f x) (part imag-part (- f) x))
         (list (part real-part f e) (part imag-part f e))))

;; ---------------------------------------------------------------------------
;; Vectors

;; Of the space that belongs to the m eigenvalues near z: orthonormal vectors, real for a real z.
;; The shift lies a little beside z, where the shifted matrix may be singular.
(define (invariant-basis B m z size stop)
  (define n (vector-length B))
  (define beside (+ z (* 1e-6 size)))
  (define shifted (rows-combine - B (unit-rows n beside 0.0)))
  (define (start k) (for/vector ([i (in-range n)]) (sin (+ 1.0 (* 1.7 i) (* 2.3 k (+ i 1))))))
  (for/fold ([vs (orthonormal (build-list m start))]) ([_ 50])
    (define solved (floating-solutions shifted (rows-transpose (list->vector vs))))
    (when (eq? solved 'singular) (stop (trouble 'not-semisimple (list (* 0+1i z)) 0.0)))
    (orthonormal (vector->list (rows-transpose solved)))))

(define (combination coefficients vs)
  (define terms (map times coefficients vs))
  (for/fold ([sum (car terms)]) ([term (in-list (cdr terms))]) (vector-sum sum term)))

(define (orthonormal vs)
  (for/fold ([found '()] #:result (reverse found)) ([v (in-list vs)])
    (define free
      (for/fold ([v v]) ([w (in-list (append found found))])
        (vector-sum v (times (- (inner w v)) w))))
    (cons (times (/ (norm free)) free) found)))
