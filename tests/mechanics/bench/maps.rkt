#lang racket/base
;; A map of the plane done many times: compiled, beside loops written by hand.

(require racket/flonum
         (only-in mechanics iterated-map)
         "C.rkt" "clock.rkt" "motion-systems.rkt" "table.rkt")

(provide maps-heading maps-rows)

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
