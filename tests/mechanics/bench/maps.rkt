#lang racket/base
;; A map of the plane done many times: compiled, beside loops written by hand; and maps made of
;; motions, beside the time they may take.

(require racket/flonum
         (only-in mechanics golden-ratio invariant-circle iterated-map
                  maximal-Lyapunov-exponent up)
         (only-in mechanics/dynamics/map-indicator indicator-grid)
         (only-in mechanics/plot explore-map frame)
         (only-in mechanics/show/plot/frame frame->bytes)
         (only-in mechanics/book HHmap driven-pendulum-map [standard-map book-standard-map])
         "C.rkt" "clock.rkt" "motion-systems.rkt" "table.rkt")

(provide maps-heading maps-rows sections-heading sections-rows)

(define maps-heading
  '("map" "ours, ns each" "million a second" "loop in Racket" "ours : it" "in C" "ours : C"))

(define times 5000000)

(define (maps-rows)
  (define many-times (iterated-map (standard-map 0.6) times))
  (define ours (nanoseconds (lambda () (many-times 1.0 1.0 list void))))
  (define by-hand (nanoseconds (lambda () (standard-map-loop 0.6 1.0 1.0 times))))
  (define in-C (run-C '() (string-append headers standard-map-by-hand timing)
                      (list (number->string times))))
  (define C (and (pair? in-C) (car in-C)))
  (list (list "standard map, K = 0.6"
              (milliseconds ours) (milliseconds (/ 1e3 ours))
              (milliseconds by-hand) (ratio ours by-hand)
              (if C (milliseconds C) in-C) (ratio ours C))))

;; ---------------------------------------------------------------------------
;; Maps made of motions

(define sections-heading '("what is computed" "ours, ms" "goal, ms" "ours : goal"))

(define (sections-rows)
  (for/list ([task (in-list section-tasks)])
    (define-values (name run goal) (apply values task))
    (run)
    (define-values (result ms) (call/cpu run))
    (list name (milliseconds ms) (milliseconds goal) (ratio ms goal))))

(define (Henon-Heiles-section)
  (define T (iterated-map (HHmap 1/8 0.1 1e-10 1e-12) 500))
  (for ([k (in-range 60)]) (T (* 0.008 k) 0.0 list void)))

(define (strobe)
  ((iterated-map (driven-pendulum-map 1.0 1.0 9.8 0.05 (* 4.2 (sqrt 9.8))) 10000)
   1.0 0.0 list void))

(define (golden-circle)
  (invariant-circle (book-standard-map 0.95) (- 1 (/ 1 golden-ratio))))

(define (exponent)
  (maximal-Lyapunov-exponent (book-standard-map 10.0) (up 0.1 0.1) 1000000))

(define (chaos)
  (define starts
    (for/flvector #:length 300 ([k (in-range 300)]) (fl* (fl/ (->fl k) 300.0) turn)))
  (indicator-grid 'chaos-map (book-standard-map 1.0) starts starts 1000))

(define (million-points)
  (define win (frame 0 turn 0 turn))
  (explore-map win (book-standard-map 0.9) 99999 #:grid '(1 10))
  (frame->bytes win 'png-bytes))

(define section-tasks
  (list (list "Hénon and Heiles, 60 starts, 500 crossings each" Henon-Heiles-section 1000)
        (list "driven pendulum, 10,000 periods" strobe 150)
        (list "golden circle of K = 0.95, to rounding" golden-circle 300)
        (list "Lyapunov exponent of a map, 1,000,000 steps" exponent 200)
        (list "chaos of 300 x 300 starts, 1,000 steps, all cores (4,000 on two)" chaos 8000)
        (list "a picture of 1,000,000 points" million-points 3000)))

;; ---------------------------------------------------------------------------

(define (nanoseconds run)
  (run)
  (apply min
         (for/list ([_ (in-range 5)])
           (define-values (result ms) (call/cpu run))
           (/ (* 1e6 ms) times))))

(define turn (* 8.0 (atan 1.0)))

(define-syntax-rule (wrap e)
  (let ([x e])
    (if (and (fl<= 0.0 x) (fl< x turn)) x (fl- x (fl* turn (flfloor (fl/ x turn)))))))

(define (standard-map-loop K x y n)
  (let loop ([n n] [x x] [y y])
    (if (eqv? n 0)
        (list x y)
        (let ([z (fl+ y (fl* K (flsin x)))])
          (loop (- n 1) (wrap (fl+ x z)) (wrap z))))))

(define headers "#include <math.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <time.h>\n")

;; Nanoseconds each, fastest of five.
(define timing #<<C

static double now(void)
{
    struct timespec s;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &s);
    return 1e9*s.tv_sec + s.tv_nsec;
}

int main(int count, char **arguments)
{
    long n = atol(arguments[count - 1]);
    double p[2], best = INFINITY;
    for (int k = 0; k < 5; k++) {
        p[0] = p[1] = 1;
        double start = now();
        standard_map(p, n);
        double taken = (now() - start)/n;
        if (taken < best) best = taken;
    }
    printf("(%.3f %.17g %.17g)\n", best, p[0], p[1]);
    return 0;
}

C
  )
