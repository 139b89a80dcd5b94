#lang racket/base
;; The benchmarks can be run, and say in other languages what our compiler says.

(require racket/file racket/flonum racket/list racket/string
         mechanics/compile/Racket-code mechanics/compile/program mechanics/generic/arithmetic
         mechanics/generic/elementary
         "support/checks.rkt"
         "bench/C.rkt" "bench/motion-systems.rkt" "bench/native.rkt" "bench/program-text.rkt"
         "bench/task.rkt" "bench/tasks.rkt" "bench/teaching.rkt")

(test-case "tasks have names of their own, and are found by them"
  (define names (map task-name tasks))
  (for ([name (in-list names)])
    (check-equal? (count (lambda (n) (eq? n name)) names) 1 (format "~a" name))
    (check-eq? (task-name (find-task name)) name))
  (check-false (find-task 'unheard-of)))

(test-case "a class is written, a file for each student, with no hole left"
  (define folder (make-temporary-file "mechanics-bench~a" 'directory))
  (write-class folder 30)
  (define texts (map file->string (directory-list folder #:build? #t)))
  (delete-directory/files folder)
  (check-equal? (length texts) 30)
  (for ([text (in-list texts)]) (check-false (regexp-match? #rx"unanswered\\)" text))))

(define (refuse e) (raise-argument-error 'program-of "an expression of the inputs" e))

(define p
  (expressions->program
   '(x y)
   (list (g:+ (g:sin (g:* 3 'x)) (g:/ 'y (g:abs 'x))) 'y (g:expt 'x 'y) (g:atan 'x 'y) 2)
   refuse))

(test-case "a program in C and in Python"
  (check-equal? (string-split (program->C p) "\n" #:trim? #f)
                '("    double v2 = 3.0*y[0];"
                  "    double v3 = sin(v2);"
                  "    double v4 = fabs(y[0]);"
                  "    double v5 = y[1]/v4;"
                  "    double v6 = v3 + v5;"
                  "    double v7 = pow(y[0], y[1]);"
                  "    double v8 = atan2(y[0], y[1]);"
                  "    dy[0] = v6;"
                  "    dy[1] = y[1];"
                  "    dy[2] = v7;"
                  "    dy[3] = v8;"
                  "    dy[4] = 2.0;"
                  ""))
  (check-equal? (car (string-split (program->Python p) "\n")) "    v2 = 3.0*y[0]"))

(test-case "in C it computes the same, where there is a compiler"
  (define values-in-C
    (run-C '()
           (string-append
            "#include <math.h>\n#include <stdio.h>\n"
            "int main(void)\n{\n    double y[] = {1.3, 0.7}, dy[5];\n" (program->C p)
            "    printf(\"(%.17g %.17g %.17g %.17g %.17g)\", dy[0], dy[1], dy[2], dy[3], dy[4]);\n"
            "    return 0;\n}\n")
           '()))
  (define ours (make-flvector 5))
  (((program->maker p)) (flvector 1.3 0.7) ours)
  (if (string? values-in-C)
      (check-equal? values-in-C "no C compiler")
      (for ([x (in-flvector ours)] [y (in-list values-in-C)]) (check-= x y 1e-15))))

(test-case "motions start where their right-hand sides have values"
  (for ([m (in-list (motions))])
    (check-not-exn (lambda () ((motion-derivative m) (motion-start m))) (motion-name m)))
  (check-true (list? native-heading)))
