#lang racket/base
;; The benchmarks:  racket main.rkt [--runs N] [NAME ...]
;;
;; Without names, all.  Tables go to the terminal and to build/bench.txt.
;; Nothing here passes or fails: the machine is noisy, ratios are what counts.

(require racket/cmdline
         racket/file
         racket/runtime-path
         "big-systems.rkt" "derivatives.rkt" "ensembles.rkt" "gradients.rkt" "long-runs.rkt"
         "maps.rkt" "measure.rkt" "native.rkt" "peers.rkt" "stiff.rkt" "Taylor.rkt" "table.rkt"
         "task.rkt" "tasks.rkt" "teaching.rkt")

(define-runtime-path build "../../../build")

;; ---------------------------------------------------------------------------
;; Statistics

(define (best xs) (apply min xs))
(define (median xs)
  (define sorted (sort xs <))
  (list-ref sorted (quotient (length sorted) 2)))

;; ---------------------------------------------------------------------------
;; Tasks

(define task-heading
  `("task" "ours best" "median" "nodes" "to reach" ,@peer-names "of fastest"))

(define (task-row t runs)
  (define results (measure (task-name t) runs))
  (define good (filter pair? results))
  (define name (symbol->string (task-name t)))
  (cond [(null? good) (failed-row name (car results) task-heading)]
        [else
         (define times (map car good))
         `(,name
           ,(milliseconds (best times))
           ,(milliseconds (median times))
           ,(size-text (cadr (car good)))
           ,(figure (figure-to-reach (task-name t)))
           ,@(map figure (peer-figures (task-name t)))
           ,(ratio (best times) (fastest-peer (task-name t))))]))

(define (figure x) (if x (number->string x) "–"))
(define (size-text size) (if size (format "~a" size) "–"))

(define (failed-row name complaint heading)
  (eprintf "~a failed: ~a\n" name complaint)
  (list* name "failed" (for/list ([_ (cddr heading)]) "–")))

;; ---------------------------------------------------------------------------
;; Micro tasks

(define micro-heading '("operation" "ours" "Racket's own" "ratio" "to reach"))

(define (micro-row m runs)
  (define results (filter pair? (measure (micro-name m) (max 1 (quotient runs 2)))))
  (cond [(null? results) (failed-row (micro-title m) "no result" micro-heading)]
        [else
         (define fastest (car (sort results < #:key car)))
         (list (format "~a: ~a" (micro-name m) (micro-title m))
               (nanoseconds (car fastest))
               (nanoseconds (cadr fastest))
               (ratio (car fastest) (cadr fastest))
               (micro-reach m))]))

(define (nanoseconds x)
  (if x (string-append (milliseconds x) " ns") "–"))

;; ---------------------------------------------------------------------------
;; Growth

(define sizes-heading '("n" "CPU ms, best" "nodes"))

;; Time against size, and the exponent of the power of n that fits it.
(define (print-growth g runs table)
  (define sizes (scaling-sizes g))
  (define results
    (for/list ([t (in-list (scaling-tasks g))])
      (measure (task-name t) (max 1 (quotient runs 2)))))
  (define times (for/list ([rs (in-list results)]) (best (map car (filter pair? rs)))))
  (displayln (scaling-heading g))
  (table sizes-heading
         (for/list ([rs (in-list results)] [time (in-list times)] [n (in-list sizes)])
           (list (number->string n) (milliseconds time) (size-text (cadr (car rs))))))
  (printf "grows as n^~a from n = ~a on\n\n"
          (decimal (exponent sizes times (scaling-fit-from g))) (scaling-fit-from g)))

;; The slope of log time against log n, by least squares.
(define (exponent sizes times from)
  (define points
    (for/list ([time (in-list times)] [n (in-list sizes)] #:when (>= n from))
      (cons (log n) (log time))))
  (define (mean f) (/ (for/sum ([p (in-list points)]) (f p)) (length points)))
  (define x (mean car))
  (define y (mean cdr))
  (/ (mean (lambda (p) (* (- (car p) x) (- (cdr p) y))))
     (mean (lambda (p) (* (- (car p) x) (- (car p) x))))))

(define (decimal x) (number->string (/ (round (* 10 x)) 10)))

;; ---------------------------------------------------------------------------
;; Loading

(define load-heading '("loading" "CPU ms, best" "median" "of racket/base"))

(define loads
  '(("racket -n -e ''" "-n" "-e" "")
    ("racket -l racket/base -e 1" "-l" "racket/base" "-e" "1")
    ("racket -l racket/base -l mechanics -e 1"
     "-l" "racket/base" "-l" "mechanics" "-e" "1")))

(define (load-rows runs)
  (define times (load-times (map cdr loads) (max 5 runs)))
  (define base (best (cadr times)))
  (for/list ([l (in-list loads)] [ts (in-list times)])
    (list (car l)
          (number->string (best ts))
          (number->string (median ts))
          (ratio (best ts) base))))

;; ---------------------------------------------------------------------------

;; Tables for the chosen names; an empty choice is all.
(define (print-tables chosen runs)
  (define (wanted? name) (or (null? chosen) (memq name chosen)))
  (define (table heading rows)
    (unless (null? rows)
      (displayln (table->string (cons heading rows)))
      (flush-output)))
  (define chosen-tasks
    (filter (lambda (t) (wanted? (task-name t))) tasks))
  (for ([t (in-list chosen-tasks)])
    (printf "~a  ~a\n" (task-name t) (task-title t)))
  (unless (null? chosen-tasks) (newline))
  (table task-heading
         (for/list ([t (in-list chosen-tasks)]) (task-row t runs)))
  (table micro-heading
         (for/list ([m (in-list micros)] #:when (wanted? (micro-name m)))
           (micro-row m runs)))
  (when (wanted? 'growth)
    (table growth-heading (growth-rows))
    (table peers-heading (peers-rows)))
  (when (wanted? 'orders)
    (table order-heading (order-rows)))
  (when (wanted? 'gradients)
    (table gradient-heading (gradient-rows)))
  (when (wanted? 'chains)
    (for ([g (in-list growths)]) (print-growth g runs table)))
  (when (wanted? 'native)
    (table native-heading (native-rows)))
  (when (wanted? 'ensembles)
    (table ensembles-heading (ensembles-rows)))
  (when (wanted? 'Taylor)
    (table Taylor-heading (Taylor-rows)))
  (when (wanted? 'long)
    (table long-runs-heading (long-runs-rows)))
  (when (wanted? 'big)
    (table big-systems-heading (big-systems-rows)))
  (when (wanted? 'stiff)
    (table stiff-heading (stiff-rows))
    (table projected-heading (projected-rows)))
  (when (wanted? 'maps)
    (table maps-heading (maps-rows))
    (table sections-heading (sections-rows)))
  (when (wanted? 'class30)
    (table class-heading (class-rows 30 60 3000)))
  (when (wanted? 'class120)
    (table class-heading (class-rows 120 180 1000)))
  (when (wanted? 'load)
    (table load-heading (load-rows runs))))

(define further-tables
  '(growth orders gradients chains native ensembles Taylor long big stiff maps
    class30 class120 load))

(define (check-names names)
  (for ([name (in-list names)])
    (unless (or (find-task name) (find-micro name) (memq name further-tables))
      (raise-user-error 'bench "no task ~a; there are ~a" name
                        (append (map task-name tasks) (map micro-name micros) further-tables)))))

(module+ main
  (define runs 7)
  (define names
    (command-line
     #:program "bench"
     #:once-each
     [("--runs") n "fresh processes for each task (7)"
      (set! runs (or (string->number n) runs))]
     #:args names
     (map string->symbol names)))
  (check-names names)
  (make-directory* build)
  (define out (open-output-string))
  (define terminal (current-output-port))
  (printf "CPU milliseconds of the first run in a fresh process; peers' figures are from\n")
  (printf "another machine of the same kind, \"of fastest\" compares with the fastest of them.\n\n")
  (parameterize ([current-output-port (tee terminal out)])
    (print-tables names runs))
  (when (null? names)
    (call-with-output-file* (build-path build "bench.txt") #:exists 'truncate
      (lambda (port) (void (write-string (get-output-string out) port))))))

(define (tee a b)
  (make-output-port 'tee always-evt
                    (lambda (bytes start end non-blocking? breakable?)
                      (write-bytes bytes a start end)
                      (write-bytes bytes b start end)
                      (when (= start end) (flush-output a))
                      (- end start))
                    void))
