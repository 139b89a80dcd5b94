#lang racket/base
;; CPU milliseconds of other systems on a 2-core x86-64 machine, first run in a
;; fresh process, best of several, and what we mean to reach.  scmutils on MIT
;; Scheme 12.1 (native) and on Chez Scheme, rktsicm on Racket 8.7, Emmy on the
;; JVM, SymPy 1.14.  Emmy's figures of C1 to C5 are those of its sources of October 2024 on Clojure
;; 1.11 and OpenJDK 17, of the thread that computes; C2 and C4 were given up after four minutes.

(provide peer-names
         peer-figures      ; name -> list of number or #f, as long as peer-names
         fastest-peer      ; name -> number or #f
         figure-to-reach)  ; name -> number or #f

(define peer-names '("MIT" "Chez" "rktsicm" "Emmy" "SymPy"))

;; name: to reach, figures
(define table
  '#hasheq((L2 . (2 20 4 3 100 600))
           (L3 . (4 50 8 6 123 2700))
           (L4 . (8 100 15 12 166 #f))
           (L6 . (25 220 84 40 #f #f))
           (S2 . (6 110 11 20 473 #f))
           (S3 . (50 1770 219 385 2240 #f))
           (S4 . (800 #f 12800 48500 #f #f))
           (R1 . (30 1220 139 333 2600 #f))
           (R2 . (10 390 41 61 537 #f))
           (R3 . (5 50 10 12 #f #f))
           (R4 . (10 #f #f #f #f #f))
           (H4 . (100 #f #f #f #f #f))
           (F1 . (8 260 38 33 #f #f))
           (F2 . (50 680 270 247 #f #f))
           (F3 . (25 #f #f #f #f #f))
           (F4 . (50 #f #f #f #f #f))
           (L6d . (25 #f #f #f #f #f))
           (S3d . (50 #f #f #f #f #f))
           (J2 . (5 #f #f #f #f #f))
           (J3 . (25 #f #f #f #f #f))
           (T2 . (25 #f 839 1110 #f #f))
           (Z1 . (50 #f #f #f #f #f))
           (Z2 . (50 #f #f #f #f #f))
           (Z3 . (2000 #f #f #f #f #f))
           (C1 . (20 #f #f 1300 362 #f))
           (C3 . (10 #f #f 113 605 #f))
           (C4 . (50 #f #f #f #f #f))
           (C5 . (5 #f #f 14 340 #f))
           (C6 . (1000 #f #f #f #f #f))
           (K1 . (100 #f #f #f #f #f))
           (K2 . (1000 #f #f #f #f #f))
           (K3 . (1000 #f #f #f #f #f))
           (K4 . (100 #f #f #f #f #f))
           (K5 . (2000 #f #f #f #f #f))
           (D1 . (15 130 90 300 #f #f))
           (P3 . (20 1950 900 470 185 #f))
           (P10 . (200 #f #f #f #f #f))
           (E2 . (10 70 14 92 #f #f))
           (E3 . (15 890 160 #f #f #f))
           (E4 . (25 44800 4730 #f #f #f))
           (E20 . (2000 #f #f #f #f #f))
           (M1 . (1000 #f #f #f #f #f))
           (G6 . (1000 #f #f #f #f #f))
           (G7 . (400 #f #f #f #f #f))
           (V1 . (200 #f #f #f #f 440))     ; mpmath 1.3, with SymPy: Taylor series
           (V2 . (200 #f #f #f #f 2930))))

(define unknown (cons #f (map (lambda (_) #f) peer-names)))

(define (peer-figures name) (cdr (hash-ref table name unknown)))
(define (figure-to-reach name) (car (hash-ref table name unknown)))

(define (fastest-peer name)
  (define known (filter values (peer-figures name)))
  (and (pair? known) (apply min known)))

(define (filter keep? xs)
  (for/list ([x (in-list xs)] #:when (keep? x)) x))
