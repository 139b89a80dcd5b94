#lang racket/base
;; Tables in NumPy's format NPZ: a ZIP archive with an array in the format NPY for each column,
;; named after it.
;;
;; Columns lie one after the other in it, and rows come one after the other.  So where they are
;; written each column goes through a file of its own, in a folder that is gone afterwards; where
;; they are read, each has a port of its own.

(require file/unzip
         file/zip
         racket/file
         racket/flonum
         racket/list
         "NPY.rkt"
         "../../error/complain.rkt")

(provide write-NPZ open-NPZ)

;; next : -> flvector or #f
(define (write-NPZ who names next port)
  (for ([name (in-list names)])
    (when (regexp-match? #rx"[/\\\\\0]|^[.]*$" (symbol->string name))
      (complain who "the name of a column is that of a file in an NPZ archive\n  name: ~a" name)))
  (define folder (make-temporary-file "table-~a" 'directory))
  (define files (for/list ([name (in-list names)]) (format "~a.npy" name)))
  (dynamic-wind
   void
   (lambda ()
     (split-columns next (for/list ([f (in-list files)]) (build-path folder f)))
     (parameterize ([current-directory folder])
       (zip->output files port)))
   (lambda () (delete-directory/files folder))))

;; Each column as an array of numbers in a file of its own.
(define (split-columns next files)
  (define ports (map open-output-file files))
  (for ([p (in-list ports)]) (begin-NPY p plain-type))
  (let loop ([n 0])
    (define row (next))
    (cond [row
           (for ([x (in-flvector row)] [p (in-list ports)]) (write-number x p))
           (loop (+ n 1))]
          [else
           (for ([p (in-list ports)])
             (end-NPY p plain-type n)
             (close-output-port p))])))

;; ---------------------------------------------------------------------------
;; Reading

;; -> opened (NPY.rkt)
(define (open-NPZ who file)
  (define directory
    (with-handlers ([exn:fail? (lambda (e) (raise-no-archive who file))])
      (read-zip-directory file)))
  (define members
    (filter (lambda (m) (regexp-match? #rx#"[.]npy$" m)) (zip-directory-entries directory)))
  (when (null? members) (raise-no-archive who file))
  (joined-columns who file
                  (for/list ([m (in-list members)])
                    (define name (regexp-replace #rx"[.]npy$" (bytes->string/utf-8 m #\?) ""))
                    (open-NPY who file (lambda () (member-port file directory m)) name))))

;; The port that unzip-entry gives to its callee is left open: lengths in the head of a member may
;; be unknown, and an array tells its own.
(define (member-port file directory m)
  (let/ec return
    (unzip-entry (open-input-file file) directory m (lambda (name folder? in) (return in)))))

(define (raise-no-archive who file)
  (complain who "this is no archive of NumPy's arrays\n  file: ~a" file))

(define (joined-columns who file all)
  (define lengths (remove-duplicates (map opened-rows all)))
  (unless (= 1 (length lengths))
    (complain who "the arrays are not of one length\n  file: ~a\n  lengths: ~a" file
              (for/list ([o (in-list all)]) (list (car (opened-names o)) (opened-rows o)))))
  (opened (append-map opened-names all) (car lengths) (append-map opened-readers all)))
