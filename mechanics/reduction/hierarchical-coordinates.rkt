#lang racket/base
;; Coordinates of several bodies that part the motion of the centre of mass from the rest
;; (SICM 5.8, exercise 5.21).
;;
;; A link of the bodies j and k puts in place of j the way from j to k, with the reduced mass, and
;; in place of k their centre of mass, with the mass of both:
;;
;;     x_j' = x_k − x_j                          p_j' = (m_j p_k − m_k p_j)/(m_j + m_k)
;;     x_k' = (m_j x_j + m_k x_k)/(m_j + m_k)    p_k' = p_j + p_k
;;
;; Kinetic energies stay sums of p²/2m.  Links one after another make a tree: Jacobi's coordinates
;; are those of (0 1) (1 2) ⋯, each body linked to the centre of mass of all before it.  The
;; centre of mass of all is left if each link joins two bodies or centres of mass, and all come
;; together.
;;
;; Heliocentric coordinates are the ways from body 0 to the others and the centre of mass; in them
;; the kinetic energy is no such sum.

(require racket/list
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/scalar.rkt" "../generic/sums-and-products.rkt" "../generic/wrong-argument.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/structure.rkt")

(provide linked-canonical linked-canonical-inverse linked-masses
         Jacobi-links center-of-mass-of-links
         heliocentric-canonical heliocentric-canonical-inverse)

;; ---------------------------------------------------------------------------
;; Links

;; mj, mk : the masses of the two parts linked
(struct link (j k mj mk) #:authentic)

;; -> the links, and the masses after them
(define (link-up who masses links)
  (check-links who (length masses) links)
  (for/fold ([made '()] [masses masses] #:result (values (reverse made) masses))
            ([jk (in-list links)])
    (define-values (j k) (apply values jk))
    (define-values (mj mk) (values (list-ref masses j) (list-ref masses k)))
    (values (cons (link j k mj mk) made)
            (put masses j (g:/ (g:* mj mk) (g:+ mj mk)) k (g:+ mj mk)))))

;; The list with two of its elements replaced
(define (put xs j x k y) (list-set (list-set xs j x) k y))

;; Old coordinates and momenta to new ones, of one link, and back; of lists
(define (join l xs ps)
  (define-values (j k mj mk) (values (link-j l) (link-k l) (link-mj l) (link-mk l)))
  (define M (g:+ mj mk))
  (define-values (xj xk pj pk)
    (values (list-ref xs j) (list-ref xs k) (list-ref ps j) (list-ref ps k)))
  (values (put xs j (g:- xk xj) k (g:/ (g:+ (g:* mj xj) (g:* mk xk)) M))
          (put ps j (g:/ (g:- (g:* mj pk) (g:* mk pj)) M) k (g:+ pj pk))))

(define (part l xs ps)
  (define-values (j k mj mk) (values (link-j l) (link-k l) (link-mj l) (link-mk l)))
  (define M (g:+ mj mk))
  (define-values (share-j share-k) (values (g:/ mj M) (g:/ mk M)))
  (define-values (x X p P)
    (values (list-ref xs j) (list-ref xs k) (list-ref ps j) (list-ref ps k)))
  (values (put xs j (g:- X (g:* share-k x)) k (g:+ X (g:* share-j x)))
          (put ps j (g:- (g:* share-j P) p) k (g:+ (g:* share-k P) p))))

;; (t, x', p') ↦ (t, x, p)
(define (linked-canonical masses links)
  (of-links 'linked-canonical masses links part reverse))

;; (t, x, p) ↦ (t, x', p')
(define (linked-canonical-inverse masses links)
  (of-links 'linked-canonical-inverse masses links join values))

(define (of-links who masses links step in-order)
  (define ms (mass-list who masses))
  (define-values (made _masses) (link-up who ms links))
  (of-bodies who (length ms) (list who (value->datum masses) links)
             (lambda (xs ps)
               (for/fold ([xs xs] [ps ps]) ([l (in-list (in-order made))]) (step l xs ps)))))

;; The masses of the new coordinates, so that the kinetic energy is Σ p'²/2m'
(define (linked-masses masses links)
  (define-values (_made after) (link-up 'linked-masses (mass-list 'linked-masses masses) links))
  after)

;; (0 1) (1 2) ⋯ of n bodies
(define (Jacobi-links n)
  (unless (and (exact-integer? n) (>= n 2))
    (complain-of-argument 'Jacobi-links "a number of bodies, at least 2" n))
  (for/list ([k (in-range 1 n)]) (list (sub1 k) k)))

;; The index of the coordinate that is the centre of mass of n bodies, or #f if none is
(define (center-of-mass-of-links n links)
  (check-links 'center-of-mass-of-links n links)
  (define members         ; the bodies whose centre of mass a coordinate is; #f for a way
    (for/fold ([members (build-list n list)]) ([jk (in-list links)])
      (define-values (j k) (apply values jk))
      (define-values (of-j of-k) (values (list-ref members j) (list-ref members k)))
      (put members j #f k (and of-j of-k (append of-j of-k)))))
  (index-where members (lambda (m) (and m (= (length m) n)))))

;; ---------------------------------------------------------------------------
;; The Sun in the middle: X, xᵢ − x₀ and Σ p, pᵢ − mᵢ/M Σ p

(define (heliocentric-canonical masses)
  (of-Sun 'heliocentric-canonical masses
          (lambda (ms M xs ps)
            (define-values (X P) (values (car xs) (car ps)))
            (define x0 (g:- X (g:/ (sum-of-products (cdr ms) (cdr xs)) M)))
            (define others (shared-momenta g:+ ms M P ps))
            (values (cons x0 (map (lambda (x) (g:+ x x0)) (cdr xs)))
                    (cons (for/fold ([p0 P]) ([p (in-list others)]) (g:- p0 p)) others)))))

(define (heliocentric-canonical-inverse masses)
  (of-Sun 'heliocentric-canonical-inverse masses
          (lambda (ms M xs ps)
            (define P (for/fold ([P (car ps)]) ([p (in-list (cdr ps))]) (g:+ P p)))
            (values (cons (g:/ (sum-of-products ms xs) M)
                          (map (lambda (x) (g:- x (car xs))) (cdr xs)))
                    (cons P (shared-momenta g:- ms M P ps))))))

;; p ± m/M P for all bodies but the first
(define (shared-momenta combine ms M P ps)
  (for/list ([m (in-list (cdr ms))] [p (in-list (cdr ps))])
    (combine p (g:* (g:/ m M) P))))

(define (of-Sun who masses f)
  (define ms (mass-list who masses))
  (define M (g:for/sum ([m (in-list ms)]) m))
  (of-bodies who (length ms) (list who (value->datum masses)) (lambda (xs ps) (f ms M xs ps))))

(define (sum-of-products ms xs)
  (g:for/sum ([m (in-list ms)] [x (in-list xs)]) (g:* m x)))

;; ---------------------------------------------------------------------------
;; The arguments

;; f : coordinates and momenta of n bodies, lists -> the same
(define (of-bodies who n datum f)
  (unary-function (lambda () datum) (state)
    (check-H-state who state)
    (define-values (q p) (values (coordinate state) (momentum state)))
    (unless (and (tuple? q) (= (s:length q) n))
      (complain who
                (string-append "expected the state of ~a bodies, as there are ~a masses: "
                               "(up t (up x0 x1 ...) (down p0 p1 ...)); given ~a")
                n n (describe-with-value state)))
    (define-values (xs ps) (f (structure->list q) (structure->list p)))
    (up (time state) (list->up xs) (list->down ps))))

(define (mass-list who masses)
  (define ms (if (tuple? masses) (structure->list masses) masses))
  (unless (and (list? ms) (andmap scalar? ms) (>= (length ms) 2))
    (complain-of-argument who "the masses of the bodies, a list of at least two" masses))
  ms)

(define (check-links who n links)
  (define (pair-of-indices? l)
    (and (list? l) (= (length l) 2) (andmap exact-nonnegative-integer? l)
         (not (= (first l) (second l)))))
  (unless (and (list? links) (andmap pair-of-indices? links))
    (complain who
              (string-append "links are a list of pairs of different bodies, by their numbers "
                             "from 0 on, such as ((0 1) (1 2)); given ~s")
              links))
  (for ([l (in-list links)] #:unless (andmap (lambda (i) (< i n)) l))
    (complain who "the link ~s names a body that is not there: ~a bodies have the numbers 0 to ~a"
              l n (sub1 n))))
