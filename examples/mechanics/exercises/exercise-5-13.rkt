#lang mechanics
;; Exercise 5.13 (SICM 5.4.5): linear canonical transformations
;; Checked: which of them bilinear functions generate, and how many there are
;; How: the blocks of their matrices, and the rank of the condition near the identity

(define state (up 't (up 'x_1 'x_2) (down 'p_1 'p_2)))
(define (bilinear u v)
  (+ (* (ref u 0) (+ (* 'a (ref v 0)) (* 'b (ref v 1))))
     (* (ref u 1) (+ (* 'c (ref v 0)) (* 'd (ref v 1))))))
(define (F2 t x p-prime) (bilinear p-prime x))
(define (F1 t x x-prime) (bilinear x-prime x))

;; a. By F2 the new coordinates are functions of the old ones alone: point transformations, of
;; which F1 = F2 − p' x' is 0.
(define (new-coordinates x)
  (up (+ (* 'a (ref x 0)) (* 'b (ref x 1))) (+ (* 'c (ref x 0)) (* 'd (ref x 1)))))
(define point
  (verify-equal ((F2->C-inv F2) ((F->CH (lambda (s) (coordinate ((F2->C F2) s)))) state)) state))
point
(define no-F1
  (let ([x (up 'x_1 'x_2)] [p (down 'p_1 'p_2)])
    (verify-equal (- (F2 't x p) (* p (new-coordinates x))) 0)))
no-F1

;; b, c. Matrices by F2 have no blocks that mix x and p, those by F1 none but such; products of the
;; two are of one kind or the other. A shear p = p' + σ x' is of neither kind.
(define (blocks C) ; the one of coordinates by momenta, and by coordinates
  (define M (qp-submatrix ((D-as-matrix C) state)))
  (list (m:submatrix M 0 2 2 4) (m:submatrix M 0 2 0 2)))
(define mixed-by-F2 (car (blocks (F2->C F2))))
(define unmixed-by-F1 (cadr (blocks (F1->C F1))))
(define (shear s) (up (time s) (coordinate s) (+ (momentum s) (* 'sigma (flip (coordinate s))))))
(define shear-canonical (verify-canonical shear state))
(list mixed-by-F2 unmixed-by-F1 (verdict-status shear-canonical))

;; d. Near the identity, 1 + ε A: A J + J Aᵀ = 0. With A = S J that is Sᵀ − S: any symmetric
;; S will do, and has 10 entries.
(define J (symplectic-unit 2))
(define S (m:generate 4 4 (lambda (i j) (string->symbol (format "s_~a~a" i j)))))
(define symmetric
  (verify-equal (+ (* (* S J) J) (* J (transpose (* S J)))) (- (transpose S) S)))
symmetric
(define free (for*/sum ([i 4] [j 4]) (if (<= i j) 1 0)))
free

;; The slip: eight parameters, four of each kind.
(define slip (+ 4 4))

(module+ test
  (require rackunit)
  (test-case "what is generated"
    (check-pred proved? point)
    (check-pred proved? no-F1)
    (check-pred proved? (prove-zero mixed-by-F2))
    (check-pred proved? (prove-zero unmixed-by-F1))
    (check-pred proved? symmetric))
  (test-case "what is not"
    (check-pred proved? shear-canonical)
    (check-not-equal? slip free)))
